# Writes OUT.h and OUT.cpp, which hold the words of the SPIR-V module SPV as candela::spirv::NAME.
file(READ ${SPV} hex HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1u," words "${hex}")
string(REGEX REPLACE "(([^,]+,[^,]+,[^,]+,[^,]+,[^,]+,[^,]+,[^,]+,[^,]+,))" "\\1\n" words "${words}")
file(WRITE ${OUT}.h "#pragma once\n#include <cstdint>\n#include <span>\nnamespace candela::spirv {\nextern const std::span<const std::uint32_t> ${NAME};\n}\n")
file(WRITE ${OUT}.cpp "#include \"${NAME}.h\"\nnamespace candela::spirv {\nstatic const std::uint32_t ${NAME}_words[] = {\n${words}\n};\nconst std::span<const std::uint32_t> ${NAME}{${NAME}_words};\n}\n")
