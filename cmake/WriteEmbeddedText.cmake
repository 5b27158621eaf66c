# Writes OUT.h and OUT.cpp, which hold the bytes of the file TEXT as candela::embedded::NAME.
file(READ ${TEXT} hex HEX)
string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${hex}")
string(REGEX REPLACE "(('[^']*',){16})" "\\1\n" bytes "${bytes}")
file(WRITE ${OUT}.h "#pragma once\n#include <string_view>\nnamespace candela::embedded {\nextern const std::string_view ${NAME};\n}\n")
file(WRITE ${OUT}.cpp "#include \"${NAME}.h\"\nnamespace candela::embedded {\nstatic const char ${NAME}_bytes[] = {\n${bytes}\n};\nconst std::string_view ${NAME}{${NAME}_bytes, sizeof ${NAME}_bytes};\n}\n")
