/*
 * Repeats recorded Vulkan work and compares its results with the expected ones. C99; needs vulkan.h and the loader:
 *
 *     cc -std=c99 -o reproduce reproduce.c -lvulkan && ./reproduce
 *
 * capture.h, which `candela capture` wrote, lists the modules, buffers and commands; the files beside it have the data.
 *
 * --device N             uses the Nth physical device (default: the one of the capture, else 0)
 * --module K FILE        uses FILE instead of module K
 * --dump FILE            writes the values that are compared
 * --against FILE ERROR   expects the values of --dump instead, floats and sums within this relative error
 * --timeout SECONDS      gives up after this time (default: 60)
 *
 * Exit codes: 0 all values are as expected, 1 one is not, 2 Vulkan cannot run it.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <vulkan/vulkan.h>

#define MAX_BINDINGS 16
#define MAX_PUSH_WORDS 32
#define MAX_OBJECTS 64

enum buffer_use { USE_STORAGE = 1, USE_TEXEL = 2, USE_UNIFORM = 4, USE_INDIRECT = 16 };
enum command_kind { COMMAND_WRITE, COMMAND_FILL, COMMAND_COPY, COMMAND_DISPATCH, COMMAND_DISPATCH_INDIRECT };
enum value_type { VALUE_WORD = 0, VALUE_FLOAT = 1, VALUE_SUM = 2 };

/* A compute shader with its descriptor set layout: binding i of set 0 has the use bindings[i]. */
struct module {
  const char *file;
  uint32_t push_bytes;
  uint32_t binding_count;
  uint32_t bindings[MAX_BINDINGS];
};

/* A buffer, which begins with the content of a file or, without one, with equal words. */
struct buffer {
  const char *file;
  uint64_t bytes;
  uint32_t uses;
  uint32_t word;
};

/* A write has a file, a fill a word. A copy is from `buffer` at `offset` to `target`. */
struct command {
  enum command_kind kind;
  uint32_t module;
  uint32_t buffers[MAX_BINDINGS];
  uint32_t push[MAX_PUSH_WORDS];
  uint32_t groups[3];
  uint32_t buffer;
  uint64_t offset;
  uint32_t target;
  uint64_t target_offset;
  uint64_t bytes;
  uint32_t word;
  const char *file;
};

#include "capture.h"

#define COUNT(array) ((uint32_t)(sizeof(array) / sizeof *(array)))

/* A value in expected.bin: `word` is the index of its first word in its buffer. */
struct expected_value {
  uint32_t type;
  uint32_t buffer;
  uint32_t word;
  uint32_t unused;
  double low;
  double high;
};

struct options {
  long device; /* -1: not given */
  const char *modules[MAX_OBJECTS];
  const char *dump;
  const char *against;
  double error;
  uint64_t seconds;
};

struct live_buffer {
  VkBuffer handle;
  VkDeviceMemory memory;
  VkBufferView view;
  uint32_t *words;
};

struct live_module {
  VkDescriptorSetLayout set_layout;
  VkPipelineLayout layout;
  VkPipeline pipeline;
};

static VkInstance instance;
static VkPhysicalDevice physical;
static VkDevice device;
static uint32_t queue_family;
static VkDescriptorPool pool;
static struct live_buffer buffers[MAX_OBJECTS];
static struct live_module modules[MAX_OBJECTS];

static void give_up(const char *what, long result) {
  fprintf(stderr, "cannot run: %s (%ld)\n", what, result);
  exit(2);
}

#define REQUIRE(call)                                \
  do {                                               \
    const VkResult result_ = (call);                 \
    if (result_ != VK_SUCCESS) give_up(#call, (long)result_); \
  } while (0)

static void *allocate(size_t bytes) {
  void *memory = calloc(bytes > 0 ? bytes : 1, 1);
  if (memory == NULL) give_up("out of memory", (long)bytes);
  return memory;
}

/* Returns the content of a file, which the caller frees. */
static void *read_file(const char *name, size_t *bytes) {
  FILE *file = fopen(name, "rb");
  long end = -1;
  void *content;
  if (file == NULL) give_up(name, 0);
  if (fseek(file, 0, SEEK_END) == 0) end = ftell(file);
  if (end < 0 || fseek(file, 0, SEEK_SET) != 0) give_up(name, 0);
  *bytes = (size_t)end;
  content = allocate(*bytes);
  if (fread(content, 1, *bytes, file) != *bytes) give_up(name, end);
  fclose(file);
  return content;
}

/* The names of extensions and the flag are not in all versions of vulkan.h. */
static void create_instance(void) {
  const char *portability = "VK_KHR_portability_enumeration";
  VkApplicationInfo application = {VK_STRUCTURE_TYPE_APPLICATION_INFO, NULL, "reproduce", 0, NULL, 0, VK_API_VERSION_1_2};
  VkInstanceCreateInfo info = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, NULL, 1, &application, 0, NULL, 1, &portability};
  if (vkCreateInstance(&info, NULL, &instance) == VK_SUCCESS) return;
  info.flags = info.enabledExtensionCount = 0;
  REQUIRE(vkCreateInstance(&info, NULL, &instance));
}

/* Chooses a device by its index or, if that is negative, the one on which the work was captured. */
static void choose_device(long index) {
  uint32_t count = 0;
  VkPhysicalDevice *all;
  VkPhysicalDeviceProperties properties;
  REQUIRE(vkEnumeratePhysicalDevices(instance, &count, NULL));
  all = allocate(count * sizeof *all);
  REQUIRE(vkEnumeratePhysicalDevices(instance, &count, all));
  for (uint32_t i = 0; i < count && index < 0; ++i) {
    vkGetPhysicalDeviceProperties(all[i], &properties);
    if (strcmp(properties.deviceName, CAPTURE_DEVICE) == 0) index = (long)i;
  }
  if (index < 0) printf("warning: the capture is of %s, which is not here; using device 0\n", CAPTURE_DEVICE);
  index = index < 0 ? 0 : index;
  if ((uint64_t)index >= count) give_up("there is no such device", index);
  physical = all[index];
  free(all);
  vkGetPhysicalDeviceProperties(physical, &properties);
  printf("%s on %s, driver version %u\n", CAPTURE_TITLE, properties.deviceName, properties.driverVersion);
}

static void choose_queue(void) {
  uint32_t count = 0;
  VkQueueFamilyProperties *families;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, NULL);
  families = allocate(count * sizeof *families);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families);
  for (queue_family = 0; queue_family < count; ++queue_family)
    if (families[queue_family].queueFlags & VK_QUEUE_COMPUTE_BIT) break;
  free(families);
  if (queue_family == count) give_up("there is no queue for compute shaders", 0);
}

static int has_extension(const char *name) {
  uint32_t count = 0, found = 0;
  VkExtensionProperties *all;
  REQUIRE(vkEnumerateDeviceExtensionProperties(physical, NULL, &count, NULL));
  all = allocate(count * sizeof *all);
  REQUIRE(vkEnumerateDeviceExtensionProperties(physical, NULL, &count, all));
  for (uint32_t i = 0; i < count; ++i) found = found || strcmp(all[i].extensionName, name) == 0;
  free(all);
  return (int)found;
}

static void create_device(void) {
  const float priority = 1;
  const char *extensions[2];
  const VkPhysicalDeviceFeatures features = {.robustBufferAccess = CAPTURE_ROBUST_ACCESS ? VK_TRUE : VK_FALSE};
  VkPhysicalDeviceSubgroupSizeControlFeaturesEXT sizes = {
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_SIZE_CONTROL_FEATURES_EXT, NULL, VK_TRUE, VK_FALSE};
  VkDeviceQueueCreateInfo queue = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, NULL, 0, queue_family, 1, &priority};
  VkDeviceCreateInfo info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, NULL, 0, 1, &queue, 0, NULL, 0, extensions, &features};
  if (has_extension("VK_KHR_portability_subset")) extensions[info.enabledExtensionCount++] = "VK_KHR_portability_subset";
  if (CAPTURE_SUBGROUP_SIZE > 0) {
    info.pNext = &sizes;
    extensions[info.enabledExtensionCount++] = VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME;
  }
  REQUIRE(vkCreateDevice(physical, &info, NULL, &device));
}

/* Returns a memory type that the host can map, of which there is always one. */
static uint32_t host_memory(uint32_t allowed) {
  const VkMemoryPropertyFlags wanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physical, &memory);
  for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
    if ((allowed >> i & 1u) && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
  give_up("there is no memory that the host can map", 0);
  return 0;
}

static VkBufferUsageFlags usage_of(uint32_t uses) {
  VkBufferUsageFlags usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  if (uses & USE_STORAGE) usage |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  if (uses & USE_TEXEL) usage |= VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
  if (uses & USE_UNIFORM) usage |= VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
  if (uses & USE_INDIRECT) usage |= VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
  return usage;
}

static void fill_buffer(const struct buffer *recorded, uint32_t *words) {
  size_t bytes;
  void *content;
  if (recorded->file == NULL) {
    for (uint64_t i = 0; i < recorded->bytes / 4; ++i) words[i] = recorded->word;
    return;
  }
  content = read_file(recorded->file, &bytes);
  if (bytes != recorded->bytes) give_up(recorded->file, (long)bytes);
  memcpy(words, content, bytes);
  free(content);
}

static void create_buffer(const struct buffer *recorded, struct live_buffer *buffer) {
  VkBufferCreateInfo info = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, NULL, 0, recorded->bytes, usage_of(recorded->uses),
                             VK_SHARING_MODE_EXCLUSIVE, 0, NULL};
  VkMemoryRequirements needed;
  void *mapped;
  REQUIRE(vkCreateBuffer(device, &info, NULL, &buffer->handle));
  vkGetBufferMemoryRequirements(device, buffer->handle, &needed);
  const VkMemoryAllocateInfo memory = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, NULL, needed.size,
                                       host_memory(needed.memoryTypeBits)};
  REQUIRE(vkAllocateMemory(device, &memory, NULL, &buffer->memory));
  REQUIRE(vkBindBufferMemory(device, buffer->handle, buffer->memory, 0));
  REQUIRE(vkMapMemory(device, buffer->memory, 0, VK_WHOLE_SIZE, 0, &mapped));
  buffer->words = mapped;
  fill_buffer(recorded, buffer->words);
  const VkBufferViewCreateInfo view = {VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO, NULL, 0, buffer->handle,
                                       VK_FORMAT_R32G32B32A32_UINT, 0, VK_WHOLE_SIZE};
  if (recorded->uses & USE_TEXEL) REQUIRE(vkCreateBufferView(device, &view, NULL, &buffer->view));
}

static VkDescriptorType type_of(uint32_t use) {
  if (use == USE_TEXEL) return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
  return use == USE_UNIFORM ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

static void create_layouts(const struct module *recorded, struct live_module *module) {
  VkDescriptorSetLayoutBinding bindings[MAX_BINDINGS];
  VkDescriptorSetLayoutCreateInfo set = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, NULL, 0,
                                         recorded->binding_count, bindings};
  VkPushConstantRange push = {VK_SHADER_STAGE_COMPUTE_BIT, 0, recorded->push_bytes};
  VkPipelineLayoutCreateInfo layout = {VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO, NULL, 0, 1, &module->set_layout,
                                       push.size > 0 ? 1 : 0, &push};
  for (uint32_t i = 0; i < recorded->binding_count; ++i)
    bindings[i] = (VkDescriptorSetLayoutBinding){i, type_of(recorded->bindings[i]), 1, VK_SHADER_STAGE_COMPUTE_BIT, NULL};
  REQUIRE(vkCreateDescriptorSetLayout(device, &set, NULL, &module->set_layout));
  REQUIRE(vkCreatePipelineLayout(device, &layout, NULL, &module->layout));
}

static void create_pipeline(const char *file, struct live_module *module) {
  VkShaderModuleCreateInfo code = {VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, NULL, 0, 0, NULL};
  VkPipelineShaderStageRequiredSubgroupSizeCreateInfoEXT size = {
      VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_REQUIRED_SUBGROUP_SIZE_CREATE_INFO_EXT, NULL, CAPTURE_SUBGROUP_SIZE};
  VkComputePipelineCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
      .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, .stage = VK_SHADER_STAGE_COMPUTE_BIT},
      .layout = module->layout};
  uint32_t *words = read_file(file, &code.codeSize);
  code.pCode = words;
  info.stage.pName = "main";
  if (CAPTURE_SUBGROUP_SIZE > 0) info.stage.pNext = &size;
  REQUIRE(vkCreateShaderModule(device, &code, NULL, &info.stage.module));
  REQUIRE(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, NULL, &module->pipeline));
  vkDestroyShaderModule(device, info.stage.module, NULL);
  free(words);
}

static void create_pool(void) {
  const uint32_t count = COUNT(capture_commands) * MAX_BINDINGS;
  const VkDescriptorPoolSize sizes[3] = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, count},
                                         {VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, count},
                                         {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, count}};
  VkDescriptorPoolCreateInfo info = {VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, NULL, 0, COUNT(capture_commands), 3,
                                     sizes};
  REQUIRE(vkCreateDescriptorPool(device, &info, NULL, &pool));
}

static VkDescriptorSet bind_buffers(const struct command *command) {
  const struct module *recorded = &capture_modules[command->module];
  VkDescriptorSetAllocateInfo info = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO, NULL, pool, 1,
                                      &modules[command->module].set_layout};
  VkDescriptorSet set;
  REQUIRE(vkAllocateDescriptorSets(device, &info, &set));
  for (uint32_t i = 0; i < recorded->binding_count; ++i) {
    const struct live_buffer *buffer = &buffers[command->buffers[i]];
    const VkDescriptorBufferInfo range = {buffer->handle, 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET, NULL, set, i, 0, 1,
                                  type_of(recorded->bindings[i]), NULL, &range, &buffer->view};
    vkUpdateDescriptorSets(device, 1, &write, 0, NULL);
  }
  return set;
}

static void record_dispatch(VkCommandBuffer commands, const struct command *command) {
  const struct live_module *module = &modules[command->module];
  const uint32_t push_bytes = capture_modules[command->module].push_bytes;
  const VkDescriptorSet set = bind_buffers(command);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, module->pipeline);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, module->layout, 0, 1, &set, 0, NULL);
  if (push_bytes > 0)
    vkCmdPushConstants(commands, module->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes, command->push);
  if (command->kind == COMMAND_DISPATCH_INDIRECT) {
    vkCmdDispatchIndirect(commands, buffers[command->buffer].handle, command->offset);
  } else {
    vkCmdDispatch(commands, command->groups[0], command->groups[1], command->groups[2]);
  }
}

static void record_write(VkCommandBuffer commands, const struct command *command) {
  size_t bytes;
  void *content = read_file(command->file, &bytes);
  for (size_t at = 0; at < bytes; at += 65536) {
    const size_t part = bytes - at < 65536 ? bytes - at : 65536;
    vkCmdUpdateBuffer(commands, buffers[command->buffer].handle, command->offset + at, part, (char *)content + at);
  }
  free(content);
}

/* Every command waits for those before it; the host waits for all. */
static void record_barrier(VkCommandBuffer commands) {
  const VkMemoryBarrier barrier = {VK_STRUCTURE_TYPE_MEMORY_BARRIER, NULL, VK_ACCESS_MEMORY_WRITE_BIT,
                                   VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                       VK_PIPELINE_STAGE_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0, NULL, 0, NULL);
}

static void record_command(VkCommandBuffer commands, const struct command *command) {
  const VkBufferCopy copy = {command->offset, command->target_offset, command->bytes};
  const VkBuffer buffer = buffers[command->buffer].handle;
  if (command->kind == COMMAND_WRITE) {
    record_write(commands, command);
  } else if (command->kind == COMMAND_FILL) {
    vkCmdFillBuffer(commands, buffer, command->offset, command->bytes, command->word);
  } else if (command->kind == COMMAND_COPY) {
    vkCmdCopyBuffer(commands, buffer, buffers[command->target].handle, 1, &copy);
  } else {
    record_dispatch(commands, command);
  }
  record_barrier(commands);
}

static void submit(VkCommandBuffer commands, uint64_t seconds) {
  VkSubmitInfo work = {VK_STRUCTURE_TYPE_SUBMIT_INFO, NULL, 0, NULL, NULL, 1, &commands, 0, NULL};
  VkFenceCreateInfo info = {VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, NULL, 0};
  VkQueue queue;
  VkFence fence;
  vkGetDeviceQueue(device, queue_family, 0, &queue);
  REQUIRE(vkCreateFence(device, &info, NULL, &fence));
  REQUIRE(vkQueueSubmit(queue, 1, &work, fence));
  REQUIRE(vkWaitForFences(device, 1, &fence, VK_TRUE, seconds * 1000000000u));
}

static void run_commands(uint64_t seconds) {
  VkCommandPoolCreateInfo info = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, NULL, 0, queue_family};
  VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, NULL,
                                    VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT, NULL};
  VkCommandPool command_pool;
  VkCommandBuffer commands;
  REQUIRE(vkCreateCommandPool(device, &info, NULL, &command_pool));
  const VkCommandBufferAllocateInfo one = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, NULL, command_pool,
                                           VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
  REQUIRE(vkAllocateCommandBuffers(device, &one, &commands));
  REQUIRE(vkBeginCommandBuffer(commands, &begin));
  for (uint32_t i = 0; i < COUNT(capture_commands); ++i) record_command(commands, &capture_commands[i]);
  REQUIRE(vkEndCommandBuffer(commands));
  submit(commands, seconds);
}

static double value_of(uint32_t type, const uint32_t *words) {
  float number;
  if (type == VALUE_WORD) return words[0];
  memcpy(&number, words, sizeof number);
  if (type == VALUE_FLOAT) return number;
  return (words[2] * 4294967296.0 + words[1]) / 256 + words[0] / 1099511627776.0;
}

static const uint32_t *words_of(const struct expected_value *value) { return buffers[value->buffer].words + value->word; }

static void print_mismatch(const struct expected_value *value, double found) {
  const uint32_t bits = *words_of(value);
  printf("buffer %u, word %u: expected ", value->buffer, value->word);
  if (value->type == VALUE_WORD && value->low == value->high) {
    printf("%.0f (0x%x), found %.0f (0x%x)\n", value->low, (uint32_t)value->low, found, bits);
  } else {
    printf("%.9g to %.9g, found %.9g (0x%x)\n", value->low, value->high, found, bits);
  }
}

static size_t word_count(const struct expected_value *value) { return value->type == VALUE_SUM ? 3 : 1; }

static void write_values(const char *name, const struct expected_value *values, size_t count) {
  FILE *file = fopen(name, "wb");
  if (file == NULL) give_up(name, 0);
  for (size_t i = 0; i < count; ++i) fwrite(words_of(&values[i]), 4, word_count(&values[i]), file);
  if (fclose(file) != 0) give_up(name, 0);
}

/* Expects the values of another execution instead. */
static void expect_values(const char *name, double error, struct expected_value *values, size_t count) {
  size_t bytes, at = 0;
  uint32_t *words = read_file(name, &bytes);
  for (size_t i = 0; i < count; ++i) {
    const double value = at < bytes / 4 ? value_of(values[i].type, words + at) : 0;
    const double margin = values[i].type == VALUE_WORD ? 0 : error * (value < 0 ? -value : value);
    values[i].low = value - margin;
    values[i].high = value + margin;
    at += word_count(&values[i]);
  }
  if (at * 4 != bytes) give_up(name, (long)bytes);
  free(words);
}

/* A NaN is as expected only where a NaN is expected. */
static int is_expected(const struct expected_value *value, double found) {
  if (value->low != value->low) return found != found;
  return found >= value->low && found <= value->high;
}

/* Returns the exit code. */
static int compare(const struct options *options) {
  size_t bytes, wrong = 0;
  struct expected_value *values = read_file("expected.bin", &bytes);
  const size_t count = bytes / sizeof *values;
  if (options->dump != NULL) write_values(options->dump, values, count);
  if (options->against != NULL) expect_values(options->against, options->error, values, count);
  for (size_t i = 0; i < count; ++i) {
    const double found = value_of(values[i].type, words_of(&values[i]));
    if (!is_expected(&values[i], found) && wrong++ == 0) print_mismatch(&values[i], found);
  }
  free(values);
  printf("%lu of %lu values differ\n", (unsigned long)wrong, (unsigned long)count);
  return wrong > 0 ? 1 : 0;
}

static struct options read_options(int count, char **words) {
  struct options options = {-1, {NULL}, NULL, NULL, 0, 60};
  for (int i = 1; i < count; ++i) {
    if (strcmp(words[i], "--device") == 0 && i + 1 < count) {
      options.device = (long)strtoul(words[++i], NULL, 10);
    } else if (strcmp(words[i], "--dump") == 0 && i + 1 < count) {
      options.dump = words[++i];
    } else if (strcmp(words[i], "--against") == 0 && i + 2 < count) {
      options.against = words[++i];
      options.error = strtod(words[++i], NULL);
    } else if (strcmp(words[i], "--timeout") == 0 && i + 1 < count) {
      options.seconds = strtoul(words[++i], NULL, 10);
    } else if (strcmp(words[i], "--module") == 0 && i + 2 < count && strtoul(words[i + 1], NULL, 10) < MAX_OBJECTS) {
      options.modules[strtoul(words[i + 1], NULL, 10)] = words[i + 2];
      i += 2;
    } else {
      give_up("options are [--device N] [--module K FILE] [--dump FILE] [--against FILE ERROR] [--timeout SECONDS]", 0);
    }
  }
  return options;
}

int main(int count, char **words) {
  const struct options options = read_options(count, words);
  create_instance();
  choose_device(options.device);
  choose_queue();
  create_device();
  for (uint32_t i = 0; i < COUNT(capture_buffers); ++i) create_buffer(&capture_buffers[i], &buffers[i]);
  for (uint32_t i = 0; i < COUNT(capture_modules); ++i) {
    create_layouts(&capture_modules[i], &modules[i]);
    create_pipeline(options.modules[i] != NULL ? options.modules[i] : capture_modules[i].file, &modules[i]);
  }
  create_pool();
  run_commands(options.seconds);
  return compare(&options);
}
