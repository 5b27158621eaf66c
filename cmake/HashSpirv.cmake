# Writes OUT, a header that holds one hash of the SPIR-V modules in the list SPV as candela::spirv::hash.
set(hashes "")
foreach(module ${SPV})
  file(SHA256 ${module} hash)
  string(APPEND hashes ${hash})
endforeach()
string(SHA256 hash "${hashes}")
file(WRITE ${OUT} "#pragma once\n#include <string_view>\nnamespace candela::spirv {\ninline constexpr std::string_view hash = \"${hash}\";\n}\n")
