// Stores the built-in variables of each invocation as a record, at the index that they imply.
#version 460
#extension GL_KHR_shader_subgroup_basic : require

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 0, std430) buffer Counts { uint counts[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { uvec4 outputs[]; };

void main() {
  uvec3 extent = gl_NumWorkGroups * gl_WorkGroupSize;
  uint i = (gl_GlobalInvocationID.z * extent.y + gl_GlobalInvocationID.y) * extent.x + gl_GlobalInvocationID.x;
  if (i >= count) return;
  atomicAdd(counts[i], 1u);
  uvec3 group = gl_WorkGroupID, size = gl_WorkGroupSize;
  outputs[i] = uvec4(group.x | group.y << 8 | group.z << 16, gl_LocalInvocationIndex,
                     size.x | size.y << 11 | size.z << 22, gl_SubgroupSize);
}
