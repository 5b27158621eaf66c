// The one place where stb_image_write is compiled; its warnings are its own.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
