// The stack of the traversal of a BVH, of one word for each entry.
#ifndef CANDELA_STACK_GLSL
#define CANDELA_STACK_GLSL
#include "options.glsl"

// The builder bounds the depth of the BVH, and kStackSize is that bound; on GPUs, the state of the BVH over instances
// is on the stack, too (instances.glsl).
const uint kStackWords = kStackSize + (kHasInstances && !kMasksLanes ? 4u : 0u);

// GPUs have the stack in shared memory, unless it is so deep that this would limit the invocations in flight, or so
// shallow that compilers have registers for it: docs/driver-workarounds.md section 17.
#ifdef CANDELA_SHARES_STACK
const uint kStackInvocations = gl_WorkGroupSize.x * gl_WorkGroupSize.y;
const uint kSharedWords = kStackWords * kStackInvocations;
const bool kFitsShared = kSharedWords <= 4096u;
const bool kIsShallow = kStackWords <= 4u;
const bool kIsDeep = kStackWords > 16u;
const bool kSharesStack = !kMasksLanes && kFitsShared && !kIsShallow && !kIsDeep;
shared uint sharedStack[kSharesStack ? kSharedWords : 1u];
#else
const bool kSharesStack = false;
#endif

uint stack[kSharesStack ? 1u : kStackWords];
uint stackTop;  // number of entries

uint stackWord(uint entry) {
#ifdef CANDELA_SHARES_STACK
  if (kSharesStack) return sharedStack[entry * kStackInvocations + gl_LocalInvocationIndex];
#endif
  return stack[entry];
}

void setStackWord(uint entry, uint word) {
#ifdef CANDELA_SHARES_STACK
  if (kSharesStack) {
    sharedStack[entry * kStackInvocations + gl_LocalInvocationIndex] = word;
    return;
  }
#endif
  stack[entry] = word;
}

#endif
