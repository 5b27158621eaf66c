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
#     AS_IS=1 executes the module as it is. Otherwise undefined values are 0 and operands for which an operation is undefined
#             are replaced, since drivers may differ in them, and unreachable blocks are removed. A loop that no branch leaves
#             is not interesting, nor are data races that the captured module does not have
#     DEFINED file to which an interesting module is written as the first execution ran it
#
# Exit codes: 0 interesting, 1 not.
set -u
candidate=$1
folder=$(mktemp -d "${TMPDIR:-/tmp}/interesting.XXXXXX") || exit 1
trap 'rm -rf "$folder"' EXIT
trap 'exit 1' INT TERM

# Gives variables of functions and of invocations an initial value of 0, replaces OpUndef by 0, replaces operands for which an
# operation is undefined, and removes dead blocks.
define() {
  spirv-dis --raw-id --no-header --no-color "$1" | awk '
    function declare(name, definition, user) {
      if (name in declared) return name
      declared[name]
      added[user < first ? user : first] = added[user < first ? user : first] name " = " definition "\n"
      return name
    }
    function null_of(type, user) { return declare("%null_" substr(type, 2), "OpConstantNull " type, user) }
    function type_of(opcode, operands,   key) {
      key = opcode " " operands
      if (!(key in types)) types[key] = declare("%type_" ++count, key, first)
      return types[key]
    }
    function constant_of(type, value,   name, text, k) {
      name = value
      gsub(/[-.+]/, "_", name)
      name = "%constant_" name "_" substr(type, 2)
      if (type in size) for (k = 1; k <= size[type]; ++k) text = text " " constant_of(component[type], value)
      return declare(name, text == "" ? "OpConstant " type " " value : "OpConstantComposite " type text, first)
    }
    # Replaces an operand by a value unless the comparison with the bound is true.
    function require_that(k, comparison, bound, value,   type, truth) {
      if (word[k] in literal && literal[word[k]] > 0 && literal[word[k]] < 32) return
      type = typed[word[k]]
      truth = type_of("OpTypeBool", "")
      if (type in size) truth = type_of("OpTypeVector", truth " " size[type])
      ++count
      before = before "%is_defined_" count " = " comparison " " truth " " word[k] " " constant_of(type, bound) "\n"
      choose(k, value)
    }
    function choose(k, value,   type) {
      type = typed[word[k]]
      before = before "%defined_" count " = OpSelect " type " %is_defined_" count " " word[k] " " constant_of(type, value) "\n"
      typed["%defined_" count] = type
      word[k] = "%defined_" count
    }
    function require_length(k,   scalar) {
      if (!(typed[word[k]] in size)) return require_that(k, "OpFOrdNotEqual", 0, 1)
      scalar = component[typed[word[k]]]
      ++count
      before = before "%square_" count " = OpDot " scalar " " word[k] " " word[k] "\n%is_defined_" count " = OpFOrdGreaterThan " \
               type_of("OpTypeBool", "") " %square_" count " " constant_of(scalar, 0) "\n"
      choose(k, 1)
    }
    function define_operands(operation) {
      if (operation ~ /^OpF(Div|Rem|Mod)$/) require_that(6, "OpFOrdNotEqual", 0, 1)
      if (operation ~ /^Op(UDiv|SDiv|UMod|SRem|SMod)$/) require_that(6, "OpINotEqual", 0, 1)
      if (operation ~ /^OpShift/) require_that(6, "OpULessThan", 32, 0)
      if (operation == "OpConvertFToU") require_that(5, "OpFOrdGreaterThan", -1, 0)
      if (operation == "OpConvertFToU") require_that(5, "OpFOrdLessThan", "4294967296", 0)
      if (operation == "OpConvertFToS") require_that(5, "OpFOrdGreaterThanEqual", "-2147483648", 0)
      if (operation == "OpConvertFToS") require_that(5, "OpFOrdLessThan", "2147483648", 0)
      if (operation == "Sqrt") require_that(7, "OpFOrdGreaterThanEqual", 0, 0)
      if (operation ~ /^(InverseSqrt|Log|Log2|Pow)$/) require_that(7, "OpFOrdGreaterThan", 0, 1)
      if (operation ~ /^(Asin|Acos)$/) require_that(7, "OpFOrdLessThanEqual", 1, 1)
      if (operation ~ /^(Asin|Acos)$/) require_that(7, "OpFOrdGreaterThanEqual", -1, 1)
      if (operation == "Normalize") require_length(7)
      if (operation ~ /^F(Min|Max|Clamp)$/) sub(/^F/, "N", word[6])
    }
    { line[NR] = $0 }
    $3 ~ /^OpType(Bool|Vector)$/ { types[$3 " " $4 ($5 == "" ? "" : " " $5)] = $1 }
    $3 == "OpTypeVector" { component[$1] = $4; size[$1] = $5 }
    $3 == "OpTypePointer" && $4 ~ /^(Function|Private)$/ { pointee[$1] = $5 }
    $3 == "OpConstant" { literal[$1] = $5 }
    $2 == "=" { typed[$1] = $4 }
    $3 == "OpFunction" && !first { first = NR }
    END {
      for (i = 1; i <= NR; ++i) {
        n = split(line[i], word, " ")
        before = ""
        if (word[3] == "OpUndef") {
          constant = word[1] " = OpConstantNull " word[4]
          if (i < first) { line[i] = constant } else { undefined = undefined constant "\n"; line[i] = "" }
        } else if (word[3] == "OpVariable" && word[4] in pointee && word[6] == "") {
          line[i] = line[i] " " null_of(pointee[word[4]], i)
        } else if (word[2] == "=" && i > first) {
          define_operands(word[3] == "OpExtInst" ? word[6] : word[3])
          line[i] = before word[1]
          for (k = 2; k <= n; ++k) line[i] = line[i] " " word[k]
        }
      }
      for (i = 1; i <= NR; ++i) printf "%s%s%s\n", added[i], i == first ? undefined : "", line[i]
    }' | spirv-as --target-env vulkan1.2 --preserve-numeric-ids - -o "$2.defined" &&
    spirv-opt --target-env=vulkan1.2 --eliminate-dead-branches --eliminate-dead-const "$2.defined" -o "$2"
}

# Tests whether a branch whose condition is not constant leaves each loop: some drivers end infinite loops.
has_exits() {
  spirv-opt --target-env=vulkan1.2 --ccp --simplify-instructions --eliminate-dead-branches "$1" -o "$1.folded" &&
    spirv-dis --raw-id --no-header --no-color "$1.folded" | awk '
    $1 == "OpLoopMerge" { merge[$2] }
    $1 == "OpBranch" || $1 == "OpBranchConditional" || $1 == "OpSwitch" { for (i = 2; i <= NF; ++i) target[$i] }
    END { for (block in merge) if (!(block in target)) exit 1 }'
}

# Tests whether several invocations write a word whose address is the same in all of them.
has_race() {
  spirv-dis --raw-id --no-header --no-color "$1" | awk '
    $3 == "LocalSize" { is_one = $4 * $5 * $6 == 1 }
    $3 == "OpTypePointer" { class[$1] = $4 }
    $2 == "=" { type[$1] = $4 }
    { for (k = 5; k <= NF; ++k) if ($2 == "=" && $k in varies) varies[$1] }
    $3 == "OpLoad" && class[type[$5]] != "PushConstant" { varies[$1] }
    $3 ~ /^Op(Phi|FunctionParameter|FunctionCall|Atomic|Image|Group)/ { varies[$1] }
    $1 == "OpStore" && class[type[$2]] == "StorageBuffer" && !($2 in varies) && !is_one { found = 1 }
    END { exit !found }'
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
  ! has_race "$first" || has_race "module_${MODULE:-0}.spv" || exit 1
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
run_first --against "$folder/values" 0 && run_second --against "$folder/others" 0 || exit 1
[ -z "${DEFINED:-}" ] || cp "$first" "$DEFINED"
