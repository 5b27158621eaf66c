// Whether a picture is true: the test of a device against the reference, and of two finished pictures.
//
//   const auto device = candela::makeGpuRenderer("");
//   const auto reference = candela::makeReferenceRenderer();
//   const candela::VerifyReport report = candela::verifyScene(scene, settings, *device, *reference, {}, {});
//   std::cout << report.verdict() << '\n';
//
// A difference is reported without cause with probability at most LightTestOptions::alpha (1e-4). docs/testing.md
// explains the tests, and what rounding can hide from them.
#pragma once
#include "host/judge/verify/film_test.h"
#include "host/judge/verify/verify.h"

namespace candela {

/// same, different, or undecided: rounding or noise may hide more than LightTestOptions::maxOverlooked() of the light.
using verify::Conclusion;
/// Probability of a false alarm in (0, 1), the relative bias to be detected, a time limit in seconds.
using verify::LightTestOptions;
/// Answers three questions: the same paths? the same light? the right light, if the scene states it?
using verify::VerifyReport;
/// Renders on both tracers until the questions are answered. Throws as Renderer::prepare() and Session::advance() do.
using verify::verifyScene;

/// The test of two pictures of films with different seeds, from their variances and numbers of samples.
using verify::FilmTestResult;
using verify::testFilms;
using verify::whyNotTestable;

}  // namespace candela
