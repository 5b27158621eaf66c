#!/bin/sh
# groff formats every page without a warning.
command -v groff > /dev/null || { echo "groff is not installed: apt-get install groff-base"; exit 1; }
failures=0
for page in "$1"/*.1.gz; do
  warnings=$(zcat "$page" | groff -man -ww -z -Tutf8 2>&1)
  [ -z "$warnings" ] || { echo "$page: $warnings"; failures=1; }
  zcat "$page" | groff -man -Tutf8 -P-bcou | grep -q "^EXIT STATUS" || { echo "$page: no exit status"; failures=1; }
done
exit $failures
