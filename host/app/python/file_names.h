// Names of files and other texts between Python and the library, in the encoding of the file system.
#pragma once
#include <pybind11/pybind11.h>

#include <filesystem>
#include <string>

namespace candela::python {

/// Returns whether `value` can be the name of a file: str, bytes or an os.PathLike.
bool isFileName(const pybind11::handle& value);

/// Returns the name of a file with the bytes that the system has for it, which need not be UTF-8. Raises TypeError,
/// which names the argument `what`, for anything else, and ValueError for null characters.
std::filesystem::path fileOf(const std::string& what, const pybind11::handle& value);

/// Returns a text for people. Bytes that are not UTF-8, which names of files may have, become escapes like \xff.
pybind11::str textOf(const std::string& text);

}  // namespace candela::python
