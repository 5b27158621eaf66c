// Accesses five buffers, and checks all of them afterwards.
#include "host/drivers/conformance/bounds_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/divide_up.h"
#include "host/drivers/conformance/memory_run.h"
#include "host/drivers/conformance/shader_run.h"
#include "host/drivers/conformance/workbench.h"
#include "spirv/bounds.h"

namespace candela::conformance {
namespace {

using vulkan::BindingKind;
using vulkan::Usage;

// The size is a multiple of all alignments, so that no memory of a buffer is beyond its end.
constexpr std::uint32_t kBufferWords = 16384;
constexpr std::uint32_t kFirstWord = 0xabc00000u;
constexpr std::uint32_t kFirstWritten = 0x5ea1ed00u;
constexpr std::uint32_t kReadWords = 0, kReadVectors = 1, kReadTexels = 2, kWriteWords = 3, kAtomicWords = 4,
                        kLengths = 5;

constexpr std::array<BoundsRow, 6> kBoundsRows{{{"read_words", kReadWords, kBufferWords},
                                                {"read_vectors", kReadVectors, kBufferWords / 4},
                                                {"read_texels", kReadTexels, kBufferWords / 4},
                                                {"write_words", kWriteWords, kBufferWords},
                                                {"atomic_words", kAtomicWords, kBufferWords},
                                                {"lengths", kLengths, kBufferWords}}};

WordList indicesFor(std::uint32_t elements) {
  WordList indices{elements,    elements + 1, elements + 63, 2 * elements, 0x00ffffffu, 0x3ffffffeu,
                   0x3fffffffu, 0x40000000u,  0x7fffffffu,   0x80000000u,  0xfffffffeu, 0xffffffffu};
  for (std::uint32_t k = 0; k < 32; ++k) indices.push_back(k * 31 % elements);
  for (std::uint32_t k = 1; k < 32; ++k) indices.push_back(elements - k);
  return indices;
}

WordList pattern() {
  WordList words;
  for (std::uint32_t i = 0; i < kBufferWords; ++i) words.push_back(kFirstWord + i);
  return words;
}

/// The buffers of bounds.comp. `words`, `vectors` and `texels` have the same content.
struct BoundsBuffers {
  vulkan::Buffer inputs, outputs, words, vectors, texels;

  BoundsBuffers(vulkan::Device& device, const WordList& indices)
      : inputs(device, indices.size() * sizeof(std::uint32_t), Usage::storage),
        outputs(device, indices.size() * sizeof(Words), Usage::storage),
        words(device, kBufferWords * sizeof(std::uint32_t), Usage::storage),
        vectors(device, kBufferWords * sizeof(std::uint32_t), Usage::storage),
        texels(device, kBufferWords * sizeof(std::uint32_t), Usage::uniformTexel) {
    const WordList content = pattern();
    inputs.upload(std::as_bytes(std::span(indices)));
    outputs.fill(0);
    for (vulkan::Buffer* const buffer : {&words, &vectors, &texels}) buffer->upload(std::as_bytes(std::span(content)));
  }
};

CasePipeline pipelineOf(const BoundsRow& row) {
  using enum BindingKind;
  return {spirv::bounds,
          {.bindings = {storageBuffer, storageBuffer, storageBuffer, storageBuffer, uniformTexelBuffer},
           .pushConstantBytes = 2 * sizeof(std::uint32_t),
           .specialisations = {{0, row.function}}}};
}

vulkan::Device openFor(const Workbench& workbench) { return workbench.open({.robustBufferAccess = true}); }

void dispatchBounds(vulkan::Device& device, const BoundsRow& row, const BoundsBuffers& buffers, std::uint32_t count) {
  const std::array<std::uint32_t, 2> push{count, 0};
  const vulkan::ComputePipeline pipeline = create(pipelineOf(row), device);
  const vulkan::BindingSet bindings(
      pipeline, {&buffers.inputs, &buffers.outputs, &buffers.words, &buffers.vectors, &buffers.texels});
  device.run([&](vulkan::CommandRecorder& recorder) {
    recorder.dispatch(pipeline, bindings, std::as_bytes(std::span(push)), {.x = divideUp(count, 64u)});
  });
}

bool isOfBuffer(std::uint32_t word) { return word >= kFirstWord && word < kFirstWord + kBufferWords; }

// The last component of a vector beyond the end may also be the largest or smallest value, or 1.
bool isPermittedBeyond(const Words& found) {
  const bool isLastPermitted = found[3] <= 1 || found[3] == 0x7fffffffu || found[3] == 0xffffffffu ||
                               isOfBuffer(found[3]);
  return isLastPermitted && std::all_of(found.begin(), found.begin() + 3,
                                        [](std::uint32_t word) { return word == 0 || isOfBuffer(word); });
}

void checkReads(const BoundsRow& row, const WordList& indices, const WordList& outputs, Mismatches& mismatches) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const Words found{outputs[4 * i], outputs[4 * i + 1], outputs[4 * i + 2], outputs[4 * i + 3]};
    const std::uint32_t index = indices[i];
    if (index >= row.elements) {
      mismatches.note(
          isPermittedBeyond(found)
              ? ""
              : fmt::format("{}, index {:#x}: expected 0 or content of the buffer, found ({:#x}, {:#x}, {:#x}, {:#x})",
                            row.name, index, found[0], found[1], found[2], found[3]));
      continue;
    }
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t expected = kFirstWord + (row.function == kReadWords ? index : 4 * index + k);
      mismatches.expect(fmt::format("{}, index {}, component {}", row.name, index, k), outputPosition(i, k), expected,
                        found[k]);
    }
  }
}

void checkUnchanged(const char* what, std::uint32_t binding, const WordList& expected, const vulkan::Buffer& buffer,
                    Mismatches& mismatches) {
  const WordList found = wordsOf(buffer);
  for (std::uint32_t i = 0; i < expected.size(); ++i) {
    mismatches.expect(fmt::format("word {} of {}, to which nothing is written", i, what), {binding, i}, expected[i],
                      found[i]);
  }
}

bool contains(const WordList& words, std::uint32_t word) { return std::ranges::find(words, word) != words.end(); }

// An access beyond the end may be of any word within the buffer.
bool isPermittedWord(const BoundsRow& row, std::uint32_t before, std::uint32_t found, std::uint32_t count) {
  if (row.function == kAtomicWords) return found - before <= count;
  return found == before || found - kFirstWritten < count;
}

void checkWrites(const BoundsRow& row, const WordList& indices, const BoundsBuffers& buffers, Mismatches& mismatches) {
  const auto count = static_cast<std::uint32_t>(indices.size());
  const WordList before = pattern(), words = wordsOf(buffers.words);
  for (std::uint32_t i = 0; i < kBufferWords; ++i) {
    const bool mustChange = contains(indices, i);
    const bool isRight = isPermittedWord(row, before[i], words[i], count) && (!mustChange || words[i] != before[i]);
    mismatches.note(isRight ? ""
                            : fmt::format("{}, word {}: was {:#x}, found {:#x}", row.name, i, before[i], words[i]));
  }
  checkUnchanged("the indices", 0, indices, buffers.inputs, mismatches);
  checkUnchanged("the outputs", kOutputs, WordList(indices.size() * 4, 0), buffers.outputs, mismatches);
  checkUnchanged("the vectors", 3, before, buffers.vectors, mismatches);
  checkUnchanged("the texels", 4, before, buffers.texels, mismatches);
}

void checkLengths(const WordList& outputs, Mismatches& mismatches) {
  mismatches.expect("length of an array of words", {kOutputs, 0}, kBufferWords, outputs[0]);
  mismatches.expect("length of an array of vectors", {kOutputs, 1}, kBufferWords / 4, outputs[1]);
  mismatches.expect("size of a texel buffer", {kOutputs, 2}, kBufferWords / 4, outputs[2]);
}

}  // namespace

std::span<const BoundsRow> boundsRows() { return kBoundsRows; }

Finding compileBounds(const BoundsRow& row, const Workbench& workbench) {
  vulkan::Device device = openFor(workbench);
  create(pipelineOf(row), device);
  return passed();
}

Finding runBounds(const BoundsRow& row, const Workbench& workbench) {
  vulkan::Device device = openFor(workbench);
  const WordList indices = indicesFor(row.elements);
  const BoundsBuffers buffers(device, indices);
  dispatchBounds(device, row, buffers, static_cast<std::uint32_t>(indices.size()));
  Mismatches mismatches;
  if (row.function == kLengths) {
    checkLengths(wordsOf(buffers.outputs), mismatches);
  } else if (row.function == kWriteWords || row.function == kAtomicWords) {
    checkWrites(row, indices, buffers, mismatches);
  } else {
    checkReads(row, indices, wordsOf(buffers.outputs), mismatches);
  }
  return mismatches.finding();
}

}  // namespace candela::conformance
