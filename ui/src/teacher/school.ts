import { classesApi } from "../api/classes";
import { api } from "../api/client";
import type { Classroom, Group } from "../api/model";

/** All classes and groups. */
export interface School {
  classes: readonly Classroom[];
  groups: readonly Group[];
}

export async function loadSchool(): Promise<School> {
  const [classes, groups] = await Promise.all([classesApi.classrooms(), api.groups()]);
  return { classes, groups: groups.filter(({ of_teacher }) => !of_teacher) };
}
