// Vertices of the panels of a window.
#version 450

layout(location = 0) in vec2 position;  // in pixels
layout(location = 1) in vec2 textureCoordinates;
layout(location = 2) in vec4 colour;
layout(location = 0) out vec2 fragmentCoordinates;
layout(location = 1) out vec4 fragmentColour;

layout(push_constant) uniform Push {
  vec2 scale;
  vec2 offset;
} push;

void main() {
  fragmentCoordinates = textureCoordinates;
  fragmentColour = colour;
  gl_Position = vec4(position * push.scale + push.offset, 0.0, 1.0);
}
