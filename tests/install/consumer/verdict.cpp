// Builds a scene in memory, looks at it from two sides, and says whether a device shows its light as the reference
// does: verdict DEVICE
#include <candela/errors.h>
#include <candela/scene.h>
#include <candela/session.h>
#include <candela/settings.h>
#include <candela/verify.h>

#include <exception>
#include <iostream>

// A lamp above a grey floor.
candela::Scene lampAndFloor() {
  candela::Scene scene;
  scene.camera = candela::Camera{.from = {0, 2, 5}, .at = {0, 2, 0}};
  scene.materials.resize(2);
  scene.materials[0].diffuse = candela::DiffuseLobe{.colour = {0.5f, 0.5f, 0.5f}};
  scene.materials[1].emission = {4, 4, 4};
  candela::addPlane(scene, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}}, 0);
  candela::addSphere(scene, {{0, 2, 0}, 0.5f}, 1);
  return scene;
}

int main(int argc, char** argv) try {
  if (argc != 2) return 1;
  const candela::Scene scene = lampAndFloor();
  candela::RenderRequest request;
  request.size = candela::Extent{32, 24};
  request.sampleCount = 16;
  const candela::RenderSettings settings = candela::resolve(request, scene);

  const auto device = candela::makeGpuRenderer(argv[1]);
  const auto session = device->prepare(scene, settings);
  session->advance({0, 16}, {});
  const double front = session->film().mean(16, 12).g;
  candela::Camera behind = *scene.camera;
  behind.from.z = -behind.from.z;
  session->setCamera(behind);
  session->advance({0, 16}, {});
  const double back = session->film().mean(16, 12).g;
  std::cout << "centre of the lamp: " << front << " and " << back << '\n';

  const auto reference = candela::makeReferenceRenderer();
  const candela::VerifyReport report = candela::verifyScene(scene, settings, *device, *reference, {}, {});
  std::cout << report.verdict() << '\n';
  return report.conclusion() == candela::Conclusion::same && front == 4 && back == 4 ? 0 : 1;
} catch (const candela::Error& error) {
  std::cerr << error.what() << '\n';
  return static_cast<int>(error.code());
}
