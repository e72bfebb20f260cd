/* A library that talks too much, dies of poison, and misses otherwise. In C99, as its header promises. */
#include <groundtruth/implementations/groundtruth_implementation.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char answer[256];

const char* groundtruth_answer(const char* line) {
  const char* id = "{\"id\":";
  int length;
  puts("{\"id\":\"a1\",\"answer\":{\"kind\":\"inside\",\"lambda\":0}}");
  fflush(stdout);
  if (strstr(line, "\"hello\"") != NULL) return "{\"hello\":\"answers/1\",\"name\":\"c\",\"asks\":[\"entry\"]}";
  if (strncmp(line, id, strlen(id)) != 0) return NULL;
  if (strstr(line, "666") != NULL) abort();
  length = (int)(strchr(line, ',') - line);
  snprintf(answer, sizeof answer, "%.*s,\"answer\":{\"kind\":\"miss\"}}", length, line);
  return answer;
}
