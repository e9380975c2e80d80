#include <rayaudit/oracle.h>
#include <stdio.h>

int main(void) {
  rayaudit_case question;
  rayaudit_answer right = rayaudit_hit(0x1.1126145e9ecd5p+1), wrong = rayaudit_miss();
  rayaudit_allowed allowed = {0.5, RAYAUDIT_DOUBLE, {0}};
  rayaudit_truth truth;
  char text[2000], why[200];
  if (rayaudit_read_case("sphere 0 0 0 1 ray 0 0.5 -3 0 0 1", &question, NULL, NULL, 0) ||
      rayaudit_truth_of(&question, &truth) || truth.crossings[0].t.in_double != right.t ||
      rayaudit_agrees(&question, &right, &allowed) != 1 ||
      rayaudit_read_case("sphere 0 0 0 one ray", &question, NULL, why, sizeof why) !=
          RAYAUDIT_NO_LINE)
    return 2;
  puts(why);
  if (rayaudit_agrees(&question, &wrong, NULL) == 1) return 2;
  rayaudit_told(&question, &wrong, NULL, text, sizeof text);
  fputs(text, stdout);
  return 1;
}
