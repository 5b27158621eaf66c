// Pixels of the panels of a window: sRGB signals, blended as such.
#version 450

layout(location = 0) in vec2 fragmentCoordinates;
layout(location = 1) in vec4 fragmentColour;
layout(location = 0) out vec4 signal;

layout(set = 0, binding = 0) uniform sampler2D font;

void main() { signal = fragmentColour * texture(font, fragmentCoordinates); }
