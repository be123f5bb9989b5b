import { json } from "./client";
import type {
  ActivityTitle,
  Classroom,
  Computer,
  Door,
  Group,
  GroupChanges,
  Lesson,
  LessonChanges,
  NewGroup,
  NewLesson,
} from "./model";

/** Where the lessons of groups without a class are asked for. */
export const NO_CLASS = "none";

/** Classes, groups, lessons and the teacher's door. */
export const classesApi = {
  createGroup: (group: NewGroup) => json<Group>("POST", "/api/groups", group),
  changeGroup: (id: string, changes: GroupChanges) =>
    json<Group>("PATCH", `/api/groups/${id}`, changes),

  classrooms: async () =>
    (await json<{ classrooms: Classroom[] }>("GET", "/api/classrooms")).classrooms,
  createClassroom: (name: string) => json<Classroom>("POST", "/api/classrooms", { name }),
  renameClassroom: (id: string, name: string) =>
    json<Classroom>("PATCH", `/api/classrooms/${id}`, { name }),

  currentLesson: async (classroom: string) =>
    (await json<{ lesson: Lesson | null }>("GET", `/api/classrooms/${classroom}/lesson`)).lesson,
  lessons: async (classroom: string) =>
    (await json<{ lessons: Lesson[] }>("GET", `/api/classrooms/${classroom}/lessons`)).lessons,
  openLesson: (classroom: string, lesson: NewLesson) =>
    json<Lesson>("POST", `/api/classrooms/${classroom}/lessons`, lesson),
  changeLesson: (id: string, changes: LessonChanges) =>
    json<Lesson>("PATCH", `/api/lessons/${id}`, changes),
  activities: async () =>
    (await json<{ activities: ActivityTitle[] }>("GET", "/api/activities")).activities,

  door: () => json<Door>("GET", "/api/teacher"),
  choosePin: (pin: string) => json<Door>("PUT", "/api/teacher/pin", { pin }),
  enter: (pin: string) => json<Door>("POST", "/api/teacher/enter", { pin }),
  leave: () => json<Door>("POST", "/api/teacher/leave"),
  computer: () => json<Computer>("GET", "/api/computer"),
  renameComputer: (name: string) => json<Computer>("PATCH", "/api/computer", { name }),
};
