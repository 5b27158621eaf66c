// Writes the film of a render to its film file, as often as its interval and its cost permit.
#pragma once
#include <filesystem>

#include "host/base/log.h"
#include "host/job/film/film_file.h"
#include "host/job/film/work_report.h"
#include "host/scene/scene.h"
#include "host/trace/render/session.h"

namespace candela::job {

class Checkpoints {
 public:
  /// `scene` outlives the object. `header` is that of the film, without the members that setContent() sets,
  /// `firstSample` is the first sample of its pixels, `before` the work of earlier runs. `every` is the minimum time
  /// between two writes in seconds.
  Checkpoints(const scene::Scene& scene, std::filesystem::path file, double every, film::FilmHeader header,
              std::uint32_t firstSample, film::WorkReport before, const Log& log);

  /// Writes the film and, beside it, the report of the work. `start` is the time of monotonicSeconds() at which the
  /// render was stopped for it: everything since then counts as its cost. Returns false, with a message in the log, if
  /// that fails; then the file has its old content.
  bool write(const image::Film& film, const render::RenderStatistics& statistics, double start);
  /// Continues after a failure of the device: `header` is that of the film from now on, and `lost` the work of
  /// the session that failed.
  void continueAfterFailure(film::FilmHeader header, const film::WorkReport& lost);
  /// The time of the next write, in terms of monotonicSeconds(). It is chosen such that all writes together take at
  /// most 1 % of the time if the next one takes as long as the last. The cost of the first write is not known in
  /// advance.
  double nextWrite() const { return nextWrite_; }
  /// Returns the work of all runs on the film, as last written.
  const film::WorkReport& work() const { return work_; }

 private:
  void writeFiles(const image::Film& film, const render::RenderStatistics& statistics);

  const scene::Scene& scene_;
  std::filesystem::path file_;
  double every_;
  film::FilmHeader header_;
  std::uint32_t firstSample_;
  film::WorkReport before_, work_;
  double begun_;  ///< when the object was made, a time of monotonicSeconds()
  double nextWrite_;
  double seconds_ = 0;  ///< for all writes
  const Log& log_;
};

}  // namespace candela::job
