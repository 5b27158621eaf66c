// A part of a device's work that another program can repeat, with the results that it must produce.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "host/drivers/capture/expected_value.h"
#include "host/trace/vulkan/recording.h"

namespace candela::capture {

using Content = std::vector<std::byte>;

/// A further file in the folder of a capture.
struct TextFile {
  std::string name;
  std::string text;
};

struct Capture {
  std::string title;              ///< the case, or the scene with the pixel and the sample
  std::string expectedBy;         ///< the tracer that computed the expected values, e.g. "the reference tracer"
  std::string found;              ///< the differences on the device where it was captured; empty: none
  std::string capturedOn;         ///< name and driver of this device
  std::string deviceName;         ///< name alone, by which reproduce.c chooses the device
  std::size_t differing = 0;      ///< number of values that differ there
  std::size_t wholeCount = 0;     ///< number of expected values before invocations were removed; 0: none were
  std::string note;               ///< sentences about the picture; may be empty
  std::vector<TextFile> files;    ///< beside the program, e.g. the scene, or other forms of modules
  vulkan::Recording work;         ///< the commands whose results are expected; buffers have no other use
  std::vector<Content> contents;  ///< of each buffer before the first command; bytes that were never written are 0
  ExpectedValues expected;        ///< of the buffers of the last dispatch
};

/// Reduces a recording to the commands that decide the content of the buffers of its last dispatch. Commands before the
/// first dispatch become contents; later ones remain. Throws InternalError if there is no dispatch.
Capture cutDown(const vulkan::Recording& recording);

/// Returns the last dispatch. Throws InternalError if there is none.
const vulkan::RecordedDispatch& lastDispatch(const vulkan::Recording& recording);
vulkan::RecordedDispatch& lastDispatch(vulkan::Recording& recording);

/// Returns the index of the buffer that contains a value.
std::uint32_t bufferOf(const Capture& capture, const WordPosition& position);

}  // namespace candela::capture
