import { asFile, del, file, get, of, post, put } from "./client";
import type { ClassPreset, OwnActivityDraft, Stage } from "./model";

/** Requests about activities that a teacher makes, presets of classes, and lesson files. */
export const authoringApi = {
  list: async () => (await get("/api/own-activities")).activities,
  one: (id: string) => get("/api/own-activities/{id}", of(id)),
  save: (id: string | null, body: OwnActivityDraft) =>
    id === null
      ? post("/api/own-activities", { body })
      : put("/api/own-activities/{id}", { ...of(id), body }),
  remove: (id: string) => del("/api/own-activities/{id}", of(id)),
  restore: (id: string) => post("/api/own-activities/{id}/take-back", of(id)),
  /** A new program of the teacher, for a sample solution. */
  newProgram: () => post("/api/own-activities/programs"),
  measure: (body: Stage) => post("/api/own-activities/measure", { body }),
  /** Runs the solution and an empty program with the ideal and the realistic robot. */
  tryOut: (body: OwnActivityDraft) => post("/api/own-activities/try", { body }),

  setPreset: (classroom: string, body: ClassPreset) =>
    put("/api/classrooms/{id}/preset", { ...of(classroom), body }),

  lessonFile: (lesson: string) => file(get("/api/lessons/{id}/file", asFile(lesson))),
  writeLessonFile: (lesson: string, folder: string) =>
    post("/api/lessons/{id}/file", { ...of(lesson), body: { folder } }),
  /** An error names the file by its name in the folder where the teacher chose it. */
  openLessonFile: (chosen: File) =>
    post("/api/lessons/file", {
      params: { query: { name: chosen.name } },
      headers: { "Content-Type": "application/octet-stream" },
      body: chosen as unknown as string, // the server's description types octets as text
      bodySerializer: (octets) => octets,
    }),
  openFoundLesson: (path: string) => post("/api/lessons/file/path", { body: { path } }),
};
