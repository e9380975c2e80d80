#include <math.h>
#include <rayaudit/plugin.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/// A plugin with one flaw, which the environment names.

static void miss(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
  (void)cases, (void)count, (void)answers;
}

static rayaudit_subject subjects[2] = {{.name = "first", .format = "float", .sphere = miss},
                                       {.name = "second", .format = "double", .disk = miss}};
static rayaudit_plugin plugin = {RAYAUDIT_PLUGIN_VERSION,
                                 sizeof(rayaudit_case),
                                 sizeof(rayaudit_answer),
                                 sizeof(rayaudit_subject),
                                 2,
                                 subjects};

const rayaudit_plugin* rayaudit_plugin_entry(void) {
  static char long_name[100];
  const char* flaw = getenv("FLAW");
  rayaudit_subject* second = &subjects[1];
  if (flaw == NULL) return &plugin;
#define HAS(words) (strcmp(flaw, words) == 0)
  if (HAS("null")) return NULL;
  if (HAS("version")) plugin.version = 7;
  if (HAS("version 0")) plugin.version = 0;
  if (HAS("case size")) plugin.case_size = 136;
  if (HAS("subject size")) plugin.subject_size = 8;
  if (HAS("no subjects")) plugin.count = 0;
  if (HAS("null subjects")) plugin.subjects = NULL;
  if (HAS("many subjects")) plugin.count = (size_t)-1;
  if (HAS("null name")) second->name = NULL;
  if (HAS("empty name")) second->name = "";
  if (HAS("two words")) second->name = "two words";
  if (HAS("long name")) second->name = (const char*)memset(long_name, 'a', sizeof long_name - 1);
  if (HAS("wild name")) second->name = (const char*)13;
  if (HAS("same name")) second->name = "first", second->format = "float";
  if (HAS("same word")) second->name = "first";
  if (HAS("taken name")) second->name = "textbook";
  if (HAS("null format")) second->format = NULL;
  if (HAS("format")) second->format = "flaot";
  if (HAS("stance")) second->convention.rim = 3;
  if (HAS("negative stance")) second->convention.within = -1;
  if (HAS("inside")) second->convention.inside = 77;
  if (HAS("range")) second->convention.t_min = 2, second->convention.t_max = 1;
  if (HAS("late range")) second->convention.t_min = 5, second->convention.t_max = 8;
  if (HAS("NaN range")) second->convention.t_max = NAN;
  if (HAS("no shape")) second->disk = NULL;
  if (HAS("crash")) raise(11);
  if (HAS("exit")) exit(3);
  if (HAS("hang")) pause();
  return &plugin;
}
