// The image files of a render or of a film file: pixels, metadata and the display transform.
#pragma once
#include <map>
#include <string>

#include "host/app/cli/render_job.h"
#include "host/image/image.h"
#include "host/job/film/film_header.h"
#include "host/trace/render/renderer.h"

namespace candela::cli {

using Metadata = std::map<std::string, std::string>;

/// Returns the metadata of an image file, which describe how it was rendered.
Metadata metadataOf(const RenderJob& job, const render::RenderResult& result);
/// Returns the same from the header of a film file.
Metadata metadataOf(const film::FilmHeader& header, const image::Film& film);

/// Adds the view as text (see view::cameraText) if it is not that of the scene file.
void addMovedCamera(const scene::Camera& camera, const scene::Camera& ofFile, Metadata& metadata);

/// Returns the means of a film with these metadata, and with alpha if the film has it.
image::Image pictureOf(const image::Film& film, bool hasAlpha, Metadata metadata);

/// Returns the picture of a film file, at its place in the frame.
image::Image pictureOf(const film::FilmHeader& header, const image::Film& film, Metadata metadata);
/// States where the pixels of an image are in the frame of its render. EXR files have both.
void setPlace(image::Image& image, const render::Extent& frame, const render::Window& window);

/// Returns the integrator of a film; for one that does not name it, the default.
render::Integrator integratorOf(const film::FilmHeader& header);

/// Writes the image of an integrator to all outputs of `arguments`, as they say that it is shown. Throws FileError,
/// after all other files have been written, with a line for each one that could not be; otherwise as
/// image::writeImage() does.
void writeImages(image::Image image, const ImageFileArguments& arguments, render::Integrator integrator,
                 const Log& log);

}  // namespace candela::cli
