// The class Session.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <mutex>
#include <variant>

#include "host/core/errors.h"
#include "host/python/options.h"
#include "host/python/python_scene.h"
#include "host/python/rendering.h"
#include "host/python/session.h"

namespace candela::python {
namespace {

namespace py = pybind11;

/// A session that may be closed, and that refuses to be used by two threads at once.
struct SharedSession {
  std::unique_ptr<PythonSession> session;
  std::mutex busy{};

  /// Runs `use` without the GIL, and passes its messages on.
  template <class Use>
  void run(const Use& use, const py::object& progress = py::none()) {
    const std::unique_lock lock(busy, std::try_to_lock);
    if (!lock) throw UsageError("the session is in use by another thread");
    if (!session) throw UsageError("the session is closed");
    runWatched([&](const Watch& watch) { use(*session, watch); }, progress);
    session->log().passOn();
  }
  void close() {
    run([](PythonSession&, const Watch&) {});
    session.reset();
  }
};
using Shared = std::shared_ptr<SharedSession>;

Shared prepare(const PythonScene& scene, const py::kwargs& options) {
  const cli::Arguments arguments = argumentsOf(kSessionOptions, options);
  auto shared = std::make_shared<SharedSession>();
  auto log = std::make_shared<PythonLog>();
  runWatched([&](const Watch&) {
    shared->session = std::make_unique<PythonSession>(renderJobOf(scene, arguments, *log), scene.files, log);
  });
  log->passOn();
  return shared;
}

// A number of samples, a range of their indices, or None for all that are left.
std::optional<render::SampleRange> rangeOf(const py::object& samples, const PythonSession& session) {
  if (samples.is_none()) return std::nullopt;
  if (py::isinstance<py::int_>(samples)) return session.next(samples.cast<std::uint32_t>());
  if (samples.attr("step").cast<int>() != 1) throw UsageError("samples: expected a range with step 1");
  return render::SampleRange{samples.attr("start").cast<std::uint32_t>(), samples.attr("stop").cast<std::uint32_t>()};
}

void advance(SharedSession& shared, const py::object& samples, const py::object& progress) {
  if (!shared.session) throw UsageError("the session is closed");
  const std::optional<render::SampleRange> range = rangeOf(samples, *shared.session);
  shared.run([&](PythonSession& session, const Watch& watch) { session.advance(range, watch); }, progress);
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
      .def("close", &SharedSession::close, "Releases the device. Films of the session stay valid.")
      .def("__enter__", [](const Shared& shared) { return shared; })
      .def("__exit__", [](SharedSession& shared, const py::args&) { shared.close(); })
      .def_property_readonly("film", &film, "The film so far, which later samples do not change.")
      .def_property_readonly("done", &done, "Number of samples that every pixel has, counted from sample 0.")
      .def_property_readonly("spp", &total, "Number of samples per pixel of the whole render.");
}

}  // namespace candela::python
