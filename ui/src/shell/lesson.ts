import { signal } from "@preact/signals";
import { activitiesApi } from "../api/activities";
import { classesApi } from "../api/classes";
import { ServerUnreachable } from "../api/errors";
import type { GoalPicture, Lesson } from "../api/model";
import type { Level } from "../blocks/definition";
import { levelOfClass } from "./level";
import { group, report } from "./session";
import { swapMinutesOfClass } from "./swap_timer";

/** Title and activity of the lesson that is open for a class. */
export interface LessonHeader {
  title: string;
  activity: string;
  /** Name of the activity; null without one. */
  mission: string | null;
  /** Null without an activity. */
  goal: GoalPicture | null;
}

export const lesson = signal<LessonHeader | null>(null);

/** Loads the open lesson of the class of the group in the header. */
export async function loadOpenLesson(): Promise<void> {
  const id = group.peek()?.classroom_id;
  try {
    const now = id ? await classesApi.currentLesson(id) : null;
    const found = now ? await lessonHeaderOf(now.lesson) : null;
    if (group.peek()?.classroom_id !== id) return;
    lesson.value = found;
    levelOfClass.value = (now?.preset.level ?? null) as Level | null;
    swapMinutesOfClass.value = now?.preset.swap_minutes ?? null;
  } catch (error) {
    // other failures are not reported: the lesson is not worth an error line
    if (error instanceof ServerUnreachable) report(error);
  }
}

async function lessonHeaderOf(now: Lesson | null): Promise<LessonHeader | null> {
  const mission = now?.activity ?? null;
  if (!now || !(now.title || mission)) return null;
  const activity = mission ? await activitiesApi.one(mission).catch(nullUnlessUnreachable) : null;
  return {
    title: now.title || (activity?.title ?? ""),
    activity: now.title && now.title !== activity?.title ? (activity?.title ?? "") : "",
    mission: activity && mission,
    goal: activity?.goal_picture ?? null,
  };
}

/** An activity of a newer release is not shown. */
function nullUnlessUnreachable(error: unknown): null {
  if (error instanceof ServerUnreachable) throw error;
  return null;
}
