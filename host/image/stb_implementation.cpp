// Compiles stb_image_write, in a separate file so that its warnings can be disabled.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
