// A render that continues on another session if a device fails. trace_film.cpp has the loop, film_recovery.cpp what
// happens after a failure.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "host/cli/checkpoints.h"
#include "host/cli/device_failures.h"
#include "host/cli/render_watch.h"
#include "host/cli/sample_loop.h"
#include "host/cli/trace_film.h"
#include "host/core/errors.h"

namespace candela::cli {

/// The state from which a render continues: the first sample that it traces, and the work of earlier runs.
struct Inheritance {
  std::uint32_t firstSample = 0;
  film::WorkReport work;
};

/// One render on one device after the other, as long as devices fail.
class FilmTrace {
 public:
  FilmTrace(const RenderJob& job, double start, const TraceControl& control, const Log& log);

  TracedFilm run();

 private:
  bool hasFile() const { return !job_.arguments.checkpoint.empty(); }
  TracedFilm attempt();
  void begin();
  void load(const image::Film& film);
  void startOrResume();
  void continueSalvagedFilm();
  void advance();
  void pause(bool mustWrite);
  void show();
  void scheduleWrite(double start);
  film::FilmHeader headerOf(const image::Film& film) const;
  TracedFilm end();
  std::optional<TracedFilm> handle(const Error& error);
  void salvage();
  bool fallBack(const Error& error);
  TracedFilm giveUp(const Error& error);
  bool rescue(std::filesystem::path& file);
  Checkpoints checkpointsAt(const std::filesystem::path& file) const;

  const RenderJob& job_;
  const Log& log_;
  const TraceControl& control_;
  render::SampleRange range_;
  render::RenderSettings settings_;
  bool usesReference_;
  std::optional<film::FilmReader> reader_;
  RenderWatch watch_;
  DeviceFailures failures_;

  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<render::Session> session_;
  bool isReady_ = false;  ///< the session has the film so far
  film::FilmHeader header_;
  Inheritance inheritance_;
  std::optional<Checkpoints> checkpoints_;   ///< with --checkpoint, from the first session on
  std::optional<render::Salvage> salvaged_;  ///< of the last session that failed
  film::WorkReport lost_;                    ///< of all sessions that failed
  std::uint64_t samplesBefore_ = 0;          ///< in the film that the session resumed
  bool isInterrupted_ = false;
  std::optional<SampleLoop> loop_;  ///< around `session_`
};

}  // namespace candela::cli
