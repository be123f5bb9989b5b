import { signal } from "@preact/signals";
import { activitiesApi } from "../api/activities";
import { classesApi } from "../api/classes";
import { ServerGone } from "../api/errors";
import type { GoalPicture } from "../api/model";
import { group, report } from "./session";

/** Title and activity of the lesson that is open for a class. */
export interface LessonWords {
  title: string;
  activity: string;
  /** Name of the activity; null without one. */
  mission: string | null;
  /** Null without an activity. */
  goal: GoalPicture | null;
}

export const lesson = signal<LessonWords | null>(null);

/** Loads the open lesson of the class of the group in the header. */
export async function loadOpenLesson(): Promise<void> {
  const id = group.peek()?.classroom_id;
  try {
    const found = id ? await wordsOf(id) : null;
    if (group.peek()?.classroom_id === id) lesson.value = found;
  } catch (error) {
    // other failures are not reported: the lesson is not worth an error line
    if (error instanceof ServerGone) report(error);
  }
}

async function wordsOf(classroom: string): Promise<LessonWords | null> {
  const now = await classesApi.currentLesson(classroom);
  const mission = now?.activity ?? null;
  if (!now || !(now.title || mission)) return null;
  const activity = mission ? await activitiesApi.one(mission).catch(unlessGone) : null;
  return {
    title: now.title || (activity?.title ?? ""),
    activity: now.title ? (activity?.title ?? "") : "",
    mission: activity && mission,
    goal: activity?.goal_picture ?? null,
  };
}

/** An activity of a newer release is not shown. */
function unlessGone(error: unknown): null {
  if (error instanceof ServerGone) throw error;
  return null;
}
