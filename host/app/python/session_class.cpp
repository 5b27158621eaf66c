// The class Session.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <variant>

#include "host/app/python/claim.h"
#include "host/app/python/options.h"
#include "host/app/python/python_scene.h"
#include "host/app/python/rendering.h"
#include "host/app/python/session.h"
#include "host/base/errors.h"

namespace candela::python {
namespace {

namespace py = pybind11;

/// A session that may be closed, and that refuses to be used twice at once.
struct SharedSession {
  std::unique_ptr<PythonSession> session;
  std::atomic<bool> isBusy{false};

  /// Runs `use` without the GIL, and passes its messages on.
  template <class Use>
  void run(const Use& use, const py::object& progress = py::none()) {
    const Claim claim(isBusy, "the session");
    if (!session) throw UsageError("the session is closed");
    runWatched([&](const Watch& watch) { use(*session, watch); }, progress);
    session->log().passOn();
  }
  void close() {
    if (!session) return;
    const Claim claim(isBusy, "the session");
    session.reset();
  }
  /// Closes the session at the end of a `with` block. The exception that ended the block, if any, is more important
  /// than one about a session that is in use: the session then stays open.
  void leave(const py::args& exception) {
    const bool isRaised = !exception.empty() && !exception[0].is_none();
    if (!isRaised || !isBusy) close();
  }
};
using Shared = std::shared_ptr<SharedSession>;

Shared prepare(const PythonScene& scene, const py::kwargs& options) {
  const auto arguments = argumentsOf<cli::RenderArguments>(kSessionOptions, options);
  auto shared = std::make_shared<SharedSession>();
  auto log = std::make_shared<PythonLog>();
  runWatched([&](const Watch&) { shared->session = std::make_unique<PythonSession>(scene, arguments, log); });
  log->passOn();
  return shared;
}

// A number of samples, a range of their indices, or nothing for all that are left.
using Samples = std::variant<std::monostate, std::uint32_t, render::SampleRange>;

// Returns a whole number, at most the maximum of its type; nothing for negative ones. Raises TypeError for other
// objects.
std::optional<std::uint32_t> countOf(const py::handle& value) {
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!number) throw py::error_already_set();
  int overflow = 0;
  const long long whole = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow < 0 || (overflow == 0 && whole < 0)) return std::nullopt;
  constexpr std::uint32_t kMax = std::numeric_limits<std::uint32_t>::max();
  return overflow > 0 || whole > kMax ? kMax : static_cast<std::uint32_t>(whole);
}

Samples samplesOf(const py::object& samples) {
  const std::string got = py::repr(samples);
  if (samples.is_none()) return {};
  if (PyIndex_Check(samples.ptr()) != 0) {
    if (const auto count = countOf(samples)) return *count;
    throw UsageError(fmt::format("samples: expected a whole number from 0, got {}", got));
  }
  if (PyObject_TypeCheck(samples.ptr(), &PyRange_Type) == 0) {
    throw py::type_error(fmt::format("samples: expected a whole number, a range or None, got {}", got));
  }
  const auto first = countOf(samples.attr("start")), end = countOf(samples.attr("stop"));
  const bool hasGaps = countOf(samples.attr("step")) != 1;
  if (first && end && !hasGaps) return render::SampleRange{*first, *end};
  throw UsageError(fmt::format("samples: expected a range of indices from 0 with step 1, got {}", got));
}

std::optional<render::SampleRange> rangeOf(const Samples& samples, const PythonSession& session) {
  if (const auto* count = std::get_if<std::uint32_t>(&samples)) return session.next(*count);
  if (const auto* range = std::get_if<render::SampleRange>(&samples)) return *range;
  return std::nullopt;
}

void advance(SharedSession& shared, const py::object& given, const py::object& progress) {
  const Samples samples = samplesOf(given);
  shared.run([&](PythonSession& session, const Watch& watch) { session.advance(rangeOf(samples, session), watch); },
             progress);
}

std::shared_ptr<PythonFilm> film(SharedSession& shared) {
  std::shared_ptr<PythonFilm> film;
  shared.run([&](PythonSession& session, const Watch&) { film = session.film(); });
  return film;
}

void reset(SharedSession& shared, std::uint32_t seed) {
  shared.run([&](PythonSession& session, const Watch&) { session.reset(seed); });
}

std::uint32_t done(const SharedSession& shared) { return shared.session ? shared.session->done() : 0; }
std::uint32_t total(const SharedSession& shared) { return shared.session ? shared.session->total() : 0; }

}  // namespace

void defineSession(py::module_& module) {
  py::class_<SharedSession, Shared>(module, "Session", py::is_final(),
                                    "A prepared render, to which samples are added call by call.")
      .def(py::init(&prepare), py::arg("scene"), py::pos_only(),
           ("Session(scene, /, **options)\n\n" + helpOf(kSessionOptions)).c_str())
      .def("advance", &advance, py::arg("samples") = py::none(), py::kw_only(), py::arg("progress") = py::none(),
           "Adds samples to every pixel: a number, a range of indices, or None for all that are left.")
      .def("reset", &reset, py::arg("seed"), "Empties the film and starts again with other random numbers.")
      .def("close", &SharedSession::close,
           "Releases the device; a second call has no effect. Films of the session stay valid.")
      .def("__enter__", [](const Shared& shared) { return shared; })
      .def("__exit__", &SharedSession::leave)
      .def_property_readonly("film", &film, "The film so far, which later samples do not change.")
      .def_property_readonly(
          "done", &done,
          "Index of the next sample: every pixel has those before it, from sample 0 or from the start of the first "
          "range on.")
      .def_property_readonly("spp", &total, "Number of samples per pixel of the whole render.");
}

}  // namespace candela::python
