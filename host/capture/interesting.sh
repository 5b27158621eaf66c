#!/bin/sh
# Tests whether two executions of a reduced module disagree, for spirv-reduce. Run it in the folder of the capture, where
# reproduce.c has been compiled:
#
#     export ICD_A=/usr/share/vulkan/icd.d/lvp_icd.x86_64.json ICD_B=/path/to/another_icd.json
#     spirv-reduce module_0.spv -o reduced.spv -- ./interesting.sh
#
# Or with one driver and two settings, e.g. a variable that switches its optimiser off; or with one driver and two modules.
#
#     ICD_A   driver of the first execution (default: the system's)
#     ICD_B   driver of the second execution (default: ICD_A)
#     ENV_A   variables of the first execution, as NAME=VALUE NAME=VALUE ... (default: none)
#     ENV_B   variables of the second execution
#     MUTATE  command that is called with the candidate and with a file, to which it writes the module of the second execution
#     MODULE  index of the module that is reduced (default: 0)
#     MIN     number of values that must differ (default: the number in minimum.txt), so that the reduction preserves the fault
#             and does not end at another one
#     ERROR   relative difference of floats and sums that is ignored (default: 0.001)
#     LIMIT   seconds that an execution may take (default: 10): an infinite loop is not interesting
#     AS_IS=1 executes the module as it is. Otherwise undefined values are 0, since drivers may differ in them, unreachable
#             blocks are removed, and a loop that no branch leaves is not interesting
#
# Exit codes: 0 interesting, 1 not.
set -u
candidate=$1
folder=$(mktemp -d "${TMPDIR:-/tmp}/interesting.XXXXXX") || exit 1
trap 'rm -rf "$folder"' EXIT
trap 'exit 1' INT TERM

# Gives every variable of a function an initial value of 0, replaces OpUndef by 0, and removes dead blocks.
define() {
  spirv-dis --raw-id --no-header --no-color "$1" | awk '
    function null_of(type) {
      if (!(type in nulls)) { nulls[type] = "%null_" substr(type, 2); order[++count] = type }
      return nulls[type]
    }
    { line[NR] = $0 }
    $3 == "OpTypePointer" && $4 == "Function" { pointee[$1] = $5 }
    $1 == "OpFunction" || $3 == "OpFunction" { if (!first) first = NR }
    END {
      for (i = 1; i <= NR; ++i) {
        split(line[i], word, " ")
        if (word[3] == "OpUndef") {
          constant = word[1] " = OpConstantNull " word[4]
          if (i < first) { line[i] = constant } else { undefined = undefined constant "\n"; line[i] = "" }
        } else if (word[3] == "OpVariable" && word[5] == "Function" && word[6] == "") {
          line[i] = line[i] " " null_of(pointee[word[4]])
        }
      }
      for (i = 1; i <= NR; ++i) {
        if (i == first) {
          for (k = 1; k <= count; ++k) print nulls[order[k]] " = OpConstantNull " order[k]
          printf "%s", undefined
        }
        print line[i]
      }
    }' | spirv-as --target-env vulkan1.2 --preserve-numeric-ids - -o "$2.defined" &&
    spirv-opt --target-env=vulkan1.2 --eliminate-dead-branches --eliminate-dead-const "$2.defined" -o "$2"
}

# Tests whether a branch leaves each loop: some drivers end infinite loops.
has_exits() {
  spirv-dis --raw-id --no-header --no-color "$1" | awk '
    $1 == "OpLoopMerge" { merge[$2] }
    $1 == "OpBranch" || $1 == "OpBranchConditional" || $1 == "OpSwitch" { for (i = 2; i <= NF; ++i) target[$i] }
    END { for (block in merge) if (!(block in target)) exit 1 }'
}

run() {  # DRIVER VARIABLES MODULE ARGUMENTS...
  icd=${1:+VK_DRIVER_FILES=$1 VK_ICD_FILENAMES=$1} variables=$2 module=$3
  shift 3
  # Several words each:
  env $icd $variables timeout "${LIMIT:-10}" ./reproduce --module "${MODULE:-0}" "$module" "$@" >"$folder/output" 2>&1
}

run_first() { run "${ICD_A:-}" "${ENV_A:-}" "$first" "$@"; }
run_second() { run "${ICD_B:-${ICD_A:-}}" "${ENV_B:-}" "$second" "$@"; }

spirv-val --target-env vulkan1.2 "$candidate" >/dev/null 2>&1 || exit 1
first=$folder/first.spv second=$folder/second.spv
if [ "${AS_IS:-0}" = 1 ]; then
  cp "$candidate" "$first" || exit 1
else
  define "$candidate" "$first" && has_exits "$first" || exit 1
fi
second=$first
if [ -n "${MUTATE:-}" ]; then
  second=$folder/second.spv
  $MUTATE "$first" "$second" >/dev/null 2>&1 || exit 1
  spirv-val --target-env vulkan1.2 "$second" >/dev/null 2>&1 || exit 1
fi

run_first --dump "$folder/values"
[ $? -le 1 ] || exit 1
run_second --dump "$folder/others" --against "$folder/values" "${ERROR:-0.001}"
[ $? -eq 1 ] || exit 1
differing=$(sed -n 's/ of [0-9]* values differ$//p' "$folder/output")
[ "$differing" -ge "${MIN:-$(cat minimum.txt)}" ] || exit 1
# An execution that differs from itself says nothing about the other one.
run_first --against "$folder/values" 0 && run_second --against "$folder/others" 0
