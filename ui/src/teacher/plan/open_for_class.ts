import { classesApi } from "../../api/classes";
import type { ActivityChoice, Lesson } from "../../api/model";

/** Data of a class that the plan needs. */
export interface PlanClass {
  /** The open lesson, if the teacher opened it; else null. */
  readonly current: Lesson | null;
  readonly activities: readonly ActivityChoice[];
}

export async function loadPlanClass(classroom: string | null): Promise<PlanClass> {
  const [now, activities] = await Promise.all([
    classroom ? classesApi.currentLesson(classroom) : null,
    classesApi.activities(),
  ]);
  const current = now?.lesson ?? null;
  return { current: current?.by_itself === false ? current : null, activities };
}

/** Sets the activity of the open lesson, so that the whole plan is one lesson; without one, opens a lesson. */
export async function openForClass(
  classroom: string,
  current: Lesson | null,
  title: string,
  activity: string,
): Promise<void> {
  if (current) await classesApi.changeLesson(current.id, { activity });
  else await classesApi.openLesson(classroom, { title, activity });
}
