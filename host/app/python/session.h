// A render that accumulates samples call by call.
#pragma once
#include <memory>
#include <optional>

#include "host/app/cli/render_job.h"
#include "host/app/python/python_film.h"
#include "host/app/python/python_log.h"
#include "host/app/python/python_scene.h"
#include "host/app/python/watched.h"

namespace candela::python {

/// One prepared session of a renderer. One thread at a time may use it.
class PythonSession {
 public:
  PythonSession(const PythonScene& scene, const cli::RenderArguments& arguments, std::shared_ptr<PythonLog> log);

  /// Adds the samples of `range` that are missing; by default all. Returns false if `watch` stopped it. Throws
  /// UsageError for a range that does not continue the film.
  bool advance(const std::optional<render::SampleRange>& range, const Watch& watch);
  /// Returns the next `count` samples, at most the remaining ones.
  render::SampleRange next(std::uint32_t count) const;
  std::shared_ptr<PythonFilm> film();
  void reset(std::uint32_t seed);

  std::uint32_t total() const { return job_.settings.image.sampleCount; }
  std::uint32_t done() const { return done_; }
  PythonLog& log() { return *log_; }

 private:
  cli::RenderJob jobSoFar() const;

  cli::RenderArguments arguments_;
  cli::RenderJob job_;
  std::vector<std::filesystem::path> files_;
  std::shared_ptr<PythonLog> log_;  ///< the renderer writes to it
  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<render::Session> session_;
  std::optional<std::uint32_t> first_;  ///< sample of the film
  std::uint32_t done_ = 0;              ///< every pixel has the samples from the first to this one, exclusive
  std::uint32_t wanted_ = 0;            ///< end of the last range; above `done_` if that was stopped
  double seconds_ = 0;                  ///< spent in calls
};

}  // namespace candela::python
