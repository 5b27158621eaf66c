// Does nothing: a driver reports for it how many invocations a device has in flight at most.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/specialization.h"

layout(local_size_x_id = kSpecWorkgroupX, local_size_y_id = kSpecWorkgroupY) in;

void main() {}
