// Counts how many iterations of one loop the device executes in one invocation; see host/trace/vulkan/loop_limit.h.
#version 450

layout(local_size_x = 1) in;

layout(std430, set = 0, binding = 0) buffer Probe {
  uint requested;
  uint executed;
  uint state;
  uint padding;
} probe;

void main() {
  uint state = probe.state;
  uint requested = probe.requested;
  uint iterations = 0u;
  while (iterations < requested) {
    // A chain of dependent operations that no compiler can shorten, so that the iterations are executed and not
    // computed in closed form.
    state = (state ^ (state >> 15)) * 0x2c1b3c6du + iterations;
    ++iterations;
  }
  probe.state = state;
  probe.executed = iterations;
}
