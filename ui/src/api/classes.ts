import { get, of, patch, post, put } from "./client";
import type { GroupChanges, LessonChanges, NewGroup, NewLesson } from "./model";

/** The class id in requests for lessons of groups without a class. */
export const NO_CLASS = "none";

/** Requests about classes, groups, lessons and the teacher's session. */
export const classesApi = {
  createGroup: (body: NewGroup) => post("/api/groups", { body }),
  changeGroup: (id: string, body: GroupChanges) => patch("/api/groups/{id}", { ...of(id), body }),

  classrooms: async () => (await get("/api/classrooms")).classrooms,
  createClassroom: (name: string) => post("/api/classrooms", { body: { name } }),
  renameClassroom: (id: string, name: string) =>
    patch("/api/classrooms/{id}", { ...of(id), body: { name } }),

  /** The open lesson, and the preset with which the groups of the class start. */
  currentLesson: (classroom: string) => get("/api/classrooms/{id}/lesson", of(classroom)),
  lessons: async (classroom: string) =>
    (await get("/api/classrooms/{id}/lessons", of(classroom))).lessons,
  openLesson: (classroom: string, body: NewLesson) =>
    post("/api/classrooms/{id}/lessons", { ...of(classroom), body }),
  changeLesson: (id: string, body: LessonChanges) =>
    patch("/api/lessons/{id}", { ...of(id), body }),
  activities: async () => (await get("/api/activities")).activities,

  teacherSession: () => get("/api/teacher"),
  choosePin: (pin: string) => put("/api/teacher/pin", { body: { pin } }),
  enter: (pin: string) => post("/api/teacher/enter", { body: { pin } }),
  leave: () => post("/api/teacher/leave"),
  computer: () => get("/api/computer"),
  renameComputer: (name: string) => patch("/api/computer", { body: { name } }),
};
