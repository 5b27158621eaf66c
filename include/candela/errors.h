// The exceptions that every function throws, and the log.
//
// An exception states what failed and what to do, names its file and its place there, and has the exit code of
// docs/command-line.md. Messages name settings by the names of their options without dashes; a front end may call
// setSettingWords() to name them as its users do.
#pragma once
#include "host/base/errors.h"
#include "host/base/log.h"
#include "host/base/setting_words.h"
