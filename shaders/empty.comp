// Does nothing: a driver reports for it how many invocations the device has in flight at most. The workgroup is no smaller
// than any subgroup.
#version 450

layout(local_size_x = 128) in;

void main() {}
