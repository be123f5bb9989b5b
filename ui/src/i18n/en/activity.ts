import type { activity as first } from "../pt-BR/activity";

export const activity: typeof first = {
  passed: "You did it! The activity is solved.",
  missing: (what: string) => `Still missing for the activity: ${what}`,
  toTheEnd: "The program solves the activity: now let it run to its end.",
  goal: "Picture of what the robot should do",
  showGoal: "See what the robot should do",
};
