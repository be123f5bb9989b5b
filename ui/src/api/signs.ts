import { del, post, put } from "./client";

const ofClass = (id: string, sign: string) => ({ params: { path: { id, sign } } });

/** Signs that a class teaches the camera. */
export const signsApi = {
  /** The camera knows what the class taught from now on; gives the letters and what it taught. */
  use: async (classroom: string) =>
    (await put("/api/camera/classroom", { body: { classroom_id: classroom } })).signs,
  /** Begins to record what the camera sees; events tell how it goes on. */
  record: (classroom: string, sign: string) =>
    post("/api/classrooms/{id}/signs/{sign}/samples", ofClass(classroom, sign)),
  stop: () => del("/api/signs/recording"),
  forget: async (classroom: string, sign: string) =>
    (await del("/api/classrooms/{id}/signs/{sign}", ofClass(classroom, sign))).signs,
};
