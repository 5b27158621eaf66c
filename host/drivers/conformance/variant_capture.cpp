// Captures variants, with the plain forms of their modules beside them.
#include "host/drivers/conformance/variant_capture.h"

#include <fmt/format.h>

#include <cstring>
#include <map>

#include "host/drivers/capture/scene_capture.h"
#include "host/drivers/conformance/capture_case.h"
#include "host/drivers/conformance/scenes.h"
#include "host/drivers/conformance/workbench.h"
#include "host/trace/vulkan/reduced_spirv.h"

namespace candela::conformance {
namespace {

using variants::Code;
using variants::Variant;

Variant plainFormFor(const Variant& variant) {
  return variant.forbidsContraction ? variants::plainVariant() : variants::withContraction(variants::plainVariant());
}

// The words in a recording.
Code recordedWords(const vulkan::ShaderCode& made) {
  return made.specialisations.empty() ? made.words : vulkan::frozenSpirv(made.words, made.specialisations);
}

/// Makes the variant of each module, and stores its plain form.
class BothForms {
 public:
  explicit BothForms(const Variant& variant)
      : variant_(variants::preparation(variant)), plain_(variants::preparation(plainFormFor(variant))) {}

  const vulkan::PrepareShader& plain() const { return plain_; }
  vulkan::PrepareShader variant() {
    return [this](std::span<const std::uint32_t> spirv, const std::vector<vulkan::Specialisation>& values) {
      vulkan::ShaderCode made = variant_(spirv, values);
      plainOf_[recordedWords(made)] = plain_(spirv, values).words;
      return made;
    };
  }

  // Adds the plain form of each module as plain_K.spv.
  void addPlainForms(capture::Capture& capture) const {
    for (std::size_t i = 0; i < capture.work.shaders.size(); ++i) {
      const auto found = plainOf_.find(capture.work.shaders[i].spirv);
      if (found == plainOf_.end()) continue;
      std::string bytes(found->second.size() * sizeof(std::uint32_t), '\0');
      std::memcpy(bytes.data(), found->second.data(), bytes.size());
      capture.files.push_back({fmt::format("plain_{}.spv", i), bytes});
    }
    capture.note +=
        " The files plain_*.spv are other forms of the modules, which must give the same results: "
        "`./reproduce --module 0 plain_0.spv`.";
  }

 private:
  vulkan::PrepareShader variant_, plain_;
  std::map<Code, Code> plainOf_;
};

// Samples are rendered one by one, so that the film has one of them at a time.
class SampleFilms {
 public:
  SampleFilms(const Picture& picture, const vulkan::DeviceInfo& device, const vulkan::PrepareShader& form)
      : workbench_(device, {.prepareShader = form}),
        session_(workbench_.renderer().prepare(sceneNamed(picture.scene), picture.settings())) {}

  image::Film film(std::uint32_t sample) {
    session_->advance({sample, sample + 1}, {});
    return session_->film();
  }

 private:
  Workbench workbench_;
  std::unique_ptr<render::Session> session_;
};

render::PixelSample firstDifference(const Picture& picture, const vulkan::DeviceInfo& device, BothForms& forms) {
  SampleFilms plain(picture, device, forms.plain()), variant(picture, device, forms.variant());
  for (std::uint32_t sample = 0; sample < *picture.request.sampleCount; ++sample) {
    const image::Film a = plain.film(sample), b = variant.film(sample);
    for (std::uint32_t i = 0; i < a.pixels().size(); ++i) {
      if (std::memcmp(&a.pixels()[i], &b.pixels()[i], sizeof(image::FilmPixel)) == 0) continue;
      return {i % a.width(), i / a.width(), sample};
    }
  }
  return {};
}

}  // namespace

capture::Capture captureForms(const Picture& picture, const Variant& variant, const vulkan::DeviceInfo& device) {
  BothForms forms(variant);
  capture::SceneRequest request{.settings = picture.settings()};
  request.sample = firstDifference(picture, device, forms);
  request.device = {device, 0, forms.variant()};
  request.expect = {device, 0, forms.plain()};
  request.shrinkSeconds = kPictureShrinkSeconds;
  const scene::Scene& scene = sceneNamed(picture.scene);
  capture::Capture capture = capture::captureScene(scene, *capture::primitivesOf(scene), request);
  capture.expectedBy = "the plain form of the modules";
  forms.addPlainForms(capture);
  return capture;
}

capture::Capture captureVerdict(const Picture& picture, const Variant& variant, const vulkan::DeviceInfo& device) {
  BothForms forms(variant);
  capture::Capture capture = capturePicture(picture, device, forms.variant());
  forms.addPlainForms(capture);
  return capture;
}

capture::Capture captureModule(const Case& question, const Variant& variant, const vulkan::DeviceInfo& device) {
  BothForms forms(variant);
  capture::Capture capture = captureCase(question, device, forms.variant());
  forms.addPlainForms(capture);
  return capture;
}

}  // namespace candela::conformance
