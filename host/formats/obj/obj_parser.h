// The statements of OBJ files (Wavefront, "Object Files (.obj)", version 3.0).
#pragma once
#include <string_view>

#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/loader.h"
#include "host/formats/obj/obj_model.h"

namespace candela::obj {

/// Returns whether the first statement is one of OBJ and not of NFF: `v` with a number on its line, `vt`, `vn`, `vp`,
/// `o`, `g`, `mtllib`, `usemtl`, or `s` with a single argument.
bool looksLikeObj(std::string_view bytes);

/// Reads all statements. Errors are added to `log`, each with its position, and reading goes on after the statement.
/// With `lenient`, unknown statements and surplus numbers cause warnings. Throws OutOfMemoryError if the triangles need
/// more memory than the budget.
ObjModel parseObj(const scene::SceneFile& file, bool lenient, scene::DiagnosticLog& log);

}  // namespace candela::obj
