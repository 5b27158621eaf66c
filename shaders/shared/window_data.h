// Data that the host and the kernel of a window exchange.
#ifndef CANDELA_SHARED_WINDOW_DATA_H
#define CANDELA_SHARED_WINDOW_DATA_H
#include "language.h"
CANDELA_BEGIN

// Display transforms, in the order of image::ToneMap.
CANDELA_CONST uint kToneNone = 0u;
CANDELA_CONST uint kToneSrgb = 1u;
CANDELA_CONST uint kToneAces = 2u;
CANDELA_CONST uint kToneAcesHill = 3u;
CANDELA_CONST uint kToneAgx = 4u;
CANDELA_CONST uint kToneNeutral = 5u;
CANDELA_CONST uint kToneDepth = 6u;
CANDELA_CONST uint kToneHeat = 7u;

// The contents of a window, in the order of view::Mode.
CANDELA_CONST uint kShowDevice = 0u;
CANDELA_CONST uint kShowReference = 1u;
CANDELA_CONST uint kShowSplit = 2u;
CANDELA_CONST uint kShowDifference = 3u;

CANDELA_CONST uint kNoPixel = 0xffffffffu;

// Specialisation constants, so that software devices do not compute all display transforms for each pixel.
CANDELA_CONST uint kSpecWindowMode = 0u;
CANDELA_CONST uint kSpecWindowToneMap = 1u;

// Push constants. Positions are in pixels: pixel p of the picture is at origin + zoom p in the window.
struct WindowConstants {
  vec4 valueOffset;  // a value v is shown as (v - valueOffset) * valueGain, channel by channel; w is unused
  vec4 valueGain;
  uvec2 windowSize;
  uvec2 pictureSize;
  vec2 origin;
  uvec2 pointer;  // pixel of the picture whose values are stored; kNoPixel: none
  float zoom;
  float divider;           // in pixels of the picture
  float falseColourScale;  // value of v = 1: image::DisplayTransform
  float differenceGain;
  uint isBlueFirst;  // bytes of a pixel in the window: blue, green, red instead of red, green, blue
  uint repeats;      // the fractional part of the value is shown
  uint hidesZero;    // the value 0 is black
  uint isLight;      // differences are those of luminances, otherwise of the channel that differs most
};

// Values of the picture at WindowConstants::pointer: red, green, blue, samples.
struct PointedValues {
  vec4 device;
  vec4 reference;
};

CANDELA_END
#endif
