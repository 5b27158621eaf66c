// Renders a scene with an installed Candela: consumer SCENE cpu|DEVICE OUTPUT
#include <exception>
#include <iostream>
#include <memory>
#include <string>

#include "host/device/gpu_renderer.h"
#include "host/formats/load_scene.h"
#include "host/image/image.h"
#include "host/reference/reference_renderer.h"
#include "host/render/request.h"

int main(int argc, char** argv) try {
  if (argc != 4) return 1;
  const std::string device = argv[2];
  const candela::scene::Scene scene = candela::formats::loadScene(argv[1]).scene;
  const std::unique_ptr<candela::render::Renderer> renderer = device == "cpu"
                                                                  ? candela::reference::makeReferenceRenderer()
                                                                  : candela::device::makeGpuRenderer(device);
  candela::render::RenderRequest request;  // everything else is as the scene requests
  request.size = candela::render::Extent{64, 64};
  request.sampleCount = 4;
  const candela::render::RenderResult result = renderer->render(scene, candela::render::resolve(request, scene), {});
  candela::image::writeImage(argv[3], candela::image::toImage(result.film), {});
  std::cout << result.statistics.device << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
