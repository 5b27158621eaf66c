// Writes films, and measures the time that this takes.
#include "host/job/checkpoints.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/progress.h"
#include "host/job/film_identity.h"

namespace candela::job {

Checkpoints::Checkpoints(const scene::Scene& scene, std::filesystem::path file, double every, film::FilmHeader header,
                         std::uint32_t firstSample, film::WorkReport before, const Log& log)
    : scene_(scene),
      file_(std::move(file)),
      every_(every),
      header_(std::move(header)),
      firstSample_(firstSample),
      before_(std::move(before)),
      begun_(monotonicSeconds()),
      nextWrite_(begun_ + every),
      log_(log) {}

void Checkpoints::writeFiles(const image::Film& film, const render::RenderStatistics& statistics) {
  setContent(header_, film, scene_, firstSample_);
  const std::string check = film::writeFilm(file_, header_, film);
  work_ = before_;
  work_.add(film::workOf(statistics));
  work_.seconds["checkpoints"] += seconds_;
  film::writeWork(file_, check, work_);
}

void Checkpoints::continueAfterFailure(film::FilmHeader header, const film::WorkReport& lost) {
  header_ = std::move(header);
  before_.add(lost);
}

bool Checkpoints::write(const image::Film& film, const render::RenderStatistics& statistics, double start) {
  constexpr double kMinTimesItsCost = 100;
  bool written = true;
  try {
    writeFiles(film, statistics);
  } catch (const FileError& error) {
    log_.problem(error.what());
    written = false;
  }
  const double end = monotonicSeconds();
  seconds_ += end - start;
  const double cost = end - start;
  nextWrite_ = std::max({end + every_, end + kMinTimesItsCost * cost, begun_ + kMinTimesItsCost * (seconds_ + cost)});
  log_.detail(fmt::format("{}: {} after {:.3f} s, next in {:.1f} s at the earliest", file_.string(),
                          written ? "written" : "not written", end - start, nextWrite_ - end));
  return written;
}

}  // namespace candela::job
