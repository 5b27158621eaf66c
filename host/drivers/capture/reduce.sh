#!/bin/sh
# Reduces a module as long as interesting.sh finds it interesting. Run it in the folder of the capture, where reproduce.c has
# been compiled, with the variables of interesting.sh:
#
#     export ICD_A=/usr/share/vulkan/icd.d/lvp_icd.x86_64.json ICD_B=/path/to/another_icd.json
#     ./reduce.sh module_0.spv reduced.spv
#
# spirv-opt simplifies the module, and ranges of instructions are removed, at first all of them. Finally, spirv-reduce removes
# details. The output is always the smallest interesting module so far, so that a reduction can be interrupted.
#
# Exit codes: 0 the module was reduced, 1 interrupted, 2 it is not interesting or cannot be read.
set -u
[ $# -eq 2 ] || { echo "usage: ./reduce.sh MODULE.spv REDUCED.spv" >&2; exit 2; }
folder=$(mktemp -d "${TMPDIR:-/tmp}/reduce.XXXXXX") || exit 2
trap 'rm -rf "$folder"' EXIT
trap 'exit 1' INT TERM
best=$2 limit=${LIMIT:-} steps=0 start=$(date +%s)

# Removes what has no effect.
clean="--eliminate-dead-branches --eliminate-dead-functions --eliminate-dead-code-aggressive --eliminate-dead-variables
  --eliminate-dead-const --merge-blocks --remove-duplicates"
# Evaluates what is constant, and replaces memory by values.
evaluate="--eliminate-local-single-block --eliminate-local-single-store --scalar-replacement=100 --convert-local-access-chains
  --ssa-rewrite --ccp --simplify-instructions"

optimise() { spirv-opt --target-env=vulkan1.2 "$@" $clean -o "$folder/candidate" >/dev/null 2>&1; }

disassemble() { spirv-dis --raw-id --no-header --no-color "$1"; }

# Makes the file the smallest module.
adopt() {  # FILE CAUSE
  [ "$1" = "$best" ] || cp "$1" "$best" || exit 2
  disassemble "$best" >"$folder/best.txt" || exit 2
  size=$(wc -l <"$folder/best.txt")
  echo "$size instructions after $steps steps and $(($(date +%s) - start)) s: $2"
}

# Adopts the file if it is interesting and was not tested before.
try() {  # FILE CAUSE
  sum=$(cksum <"$1")
  grep -qxF "$sum" "$folder/tested" && return 1
  echo "$sum" >>"$folder/tested"
  steps=$((steps + 1)) before=$(date +%s)
  ./interesting.sh "$1" || return 1
  # An execution that takes longer than four took before has an infinite loop.
  [ -n "$limit" ] || export LIMIT=$(($(date +%s) - before + 2))
  adopt "$1" "$2"
}

# Copies a disassembly with an edit. Candidates are the instructions of functions to which it applies; those with the indices
# FROM to TO are edited. Writes the number of candidates into the file "count".
#     false, true  conditions become constant
#     null         instructions without result are removed, results become null constants
#     1, 2, 3      results become the first, second, third operand of the same type
edit() {  # EDIT FROM TO
  awk -v edit="$1" -v from="$2" -v to="$3" -v counted="$folder/count" '
    function constant_of(type, opcode) {
      if (!((type, opcode) in constants)) {
        constants[type, opcode] = "%" opcode "_" substr(type, 2)
        added = added constants[type, opcode] " = " opcode " " type "\n"
      }
      return constants[type, opcode]
    }
    function operand_of(type, number,   i, seen) {
      for (i = 5; i <= NF; ++i) if (types[$i] == type && $i != $1 && !seen[$i]++ && --number == 0) return $i
    }
    function replacement_of(type) {
      if (edit == "true") return type == bool ? constant_of(type, "OpConstantTrue") : ""
      if (edit == "null" || edit == "false" && type == bool) return constant_of(type, "OpConstantNull")
      return edit ~ /[0-9]/ ? operand_of(type, edit) : ""
    }
    function is_removed() {
      if (edit != "null") return 0
      return $1 ~ /^Op(Store|AtomicStore|CopyMemory|ImageWrite|ControlBarrier|MemoryBarrier)$/ || $3 == "OpFunctionCall"
    }
    { line[NR] = $0 }
    $3 ~ /^OpType(Bool|Int|Float|Vector|Matrix|Array|Struct)$/ { is_value[$1] }
    $3 == "OpTypeBool" { bool = $1 }
    $2 == "=" { types[$1] = $4 }
    $3 == "OpConstantNull" || $3 == "OpConstantTrue" { constants[$4, $3] = $1 }
    $3 == "OpFunction" { if (!first) first = NR; next }
    first {
      replacement = $2 == "=" && $4 in is_value ? replacement_of($4) : ""
      if (replacement == "" && !is_removed() || ++count < from || count > to) next
      if (replacement != "") replaced[$1] = replacement
      if ($3 != "OpFunctionParameter") removed[NR]
    }
    END {
      print count + 0 >counted
      for (i = 1; i <= NR; ++i) {
        if (i == first) printf "%s", added
        $0 = line[i]
        if (i in removed || i < first && $1 ~ /^Op(Name|Decorate)/ && $2 in replaced) continue
        for (k = $2 == "=" ? 4 : 2; k <= NF && i > first; ++k) {
          for (tries = 0; $k in replaced && tries < NR; ++tries) $k = replaced[$k]
        }
        print
      }
    }' "$folder/best.txt"
}

# Copies the disassembly with loop FROM, counting from 1, executed once: it becomes the only case of a switch, which branches
# may leave as they leave a loop, and the branch back to its header leaves it. Writes the number of loops into the file "count".
once() {  # FROM TO
  awk -v from="$1" -v counted="$folder/count" '
    function after(target, reference) { return start[target] > start[reference] }
    function substitute(k) { if ($k in last) $k = last[$k] }
    { line[NR] = $0 }
    $3 == "OpTypeInt" { integer = $1 }
    $3 == "OpFunction" && !first { first = NR }
    $3 == "OpLabel" { label = $1; start[$1] = NR }
    { block[NR] = label }
    $1 == "OpLoopMerge" && ++count == from { loop = NR; header = label; merge = $2 }
    $1 ~ /^OpBranch/ && header != "" && (" " $0 " ") ~ (" " header " ") && !back { back = NR }
    END {
      print count + 0 >counted
      if (!loop || integer == "") exit
      $0 = line[loop + 1]
      exits = $1 == "OpBranchConditional"
      entry = exits && $3 == merge ? $4 : exits && $4 != merge ? header : exits ? $3 : $2
      for (i = start[header] + 1; i < loop; ++i) {
        $0 = line[i]
        for (k = 5; k < NF && $3 == "OpPhi"; k += 2) if (!after(header, $(k + 1))) last[$1] = $k
      }
      for (i = 1; i <= NR; ++i) {
        $0 = line[i]
        is_phi = $3 == "OpPhi"
        if (i == first) print "%nothing = OpConstantNull " integer
        if (i == loop) $0 = "OpSelectionMerge " merge " None"
        if (i == loop + 1) $0 = "OpSwitch %nothing " entry
        if (i == back) for (k = 2; k <= NF; ++k) if ($k == header) $k = merge
        if (is_phi && block[i] == merge) $0 = $0 " " $5 " " block[back]
        for (k = 5; k < NF && is_phi; k += 2) {
          if (after($(k + 1), merge) || $(k + 1) == block[back]) substitute(k)
          if (block[i] == header && after($(k + 1), header) || block[i] == merge && exits && $(k + 1) == header) $k = $(k + 1) = ""
        }
        for (k = 2; k <= NF && !is_phi && i > start[merge]; ++k) substitute(k)
        print
      }
    }' "$folder/best.txt"
}

count() { $1 0 0 >/dev/null && cat "$folder/count"; }

# Tries an edit of each LENGTH candidates, from the last to the first, since operands precede their uses.
sweep() {  # COMMAND LENGTH
  count=$(count "$1") to=$count
  [ "$2" -le "$count" ] || return
  while [ "$to" -gt 0 ]; do
    from=$((to > $2 ? to - $2 + 1 : 1))
    if $1 $from $to | spirv-as --target-env vulkan1.2 --preserve-numeric-ids - -o "$folder/edited" 2>/dev/null &&
         optimise "$folder/edited" && try "$folder/candidate" "$1, $2 at a time"; then
      # Operands that are not used any more were removed, too.
      to=$((to - count)) count=$(count "$1") to=$((to + count))
      is_reduced=1
    else
      to=$((from - 1))
    fi
  done
}

# Tries workgroups of fewer invocations. One invocation has no data races, and few do not write beyond the ends of buffers.
shrink_workgroup() {
  whole=$(awk '$3 == "LocalSize" { print $4 * $5 * $6 }' "$folder/best.txt") count=1
  while [ "$count" -lt "${whole:-1}" ]; do
    sed "s/LocalSize .*/LocalSize $count 1 1/" "$folder/best.txt" |
      spirv-as --target-env vulkan1.2 --preserve-numeric-ids - -o "$folder/candidate" &&
      try "$folder/candidate" "a workgroup of $count" && return
    count=$((count * 2))
  done
}

# Tries passes of spirv-opt that make the module smaller.
simplify() {
  while read -r passes; do
    optimise "$best" $passes || continue
    [ "$(disassemble "$folder/candidate" | wc -l)" -lt "$size" ] && try "$folder/candidate" "$passes" && is_reduced=1
  done <<END
--strip-debug
--merge-return --inline-entry-points-exhaustive $(echo $evaluate)
--inline-entry-points-exhaustive $(echo $evaluate)
$(echo $evaluate)
--vector-dce --eliminate-dead-inserts --redundancy-elimination
--if-conversion --simplify-instructions
--eliminate-dead-members --remove-unused-interface-variables
END
}

sweeps() {
  length=$size
  while [ "$length" -gt 0 ]; do
    simplify
    sweep once 1
    for name in false true null; do sweep "edit $name" "$length"; done
    length=$((length / 2))
  done
  for number in 1 2 3; do sweep "edit $number" 1; done
}

details() {
  printf '#!/bin/sh\n./interesting.sh "$1" && cp "$1" "%s"\n' "$best" >"$folder/adopt.sh"
  chmod +x "$folder/adopt.sh"
  previous=$size
  spirv-reduce "$best" -o "$folder/reduced" --temp-file-prefix="$folder/temp_" -- "$folder/adopt.sh" >/dev/null 2>&1
  adopt "$best" spirv-reduce
  [ "$size" -ge "$previous" ] || is_reduced=1
}

rm -f "$best"
: >"$folder/tested"
try "$1" input || { echo "$1: interesting.sh finds no difference between two executions; AS_IS=1 executes it unchanged" >&2; exit 2; }
shrink_workgroup
is_reduced=1
while [ $is_reduced -eq 1 ]; do
  is_reduced=0
  sweeps
  [ $is_reduced -eq 1 ] || details
done
# The module must show the fault without the changes that interesting.sh makes.
DEFINED=$folder/defined ./interesting.sh "$best" && adopt "$folder/defined" "with all operations defined"
