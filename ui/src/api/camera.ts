import { del, get, post, put } from "./client";

/** Requests about the camera that recognises signs; its results come as events. */
export const cameraApi = {
  status: () => get("/api/camera"),
  choose: (source: string) => put("/api/camera", { body: { source } }),
  /** Starts the camera process so that it is ready to recognise signs; the camera stays off. */
  warmUp: () => post("/api/camera/wake"),
};

/** What reads the signs: the landmarks ("") or a detector of this PC. For the teacher. */
export const recognizersApi = {
  list: () => get("/api/camera/recognizers"),
  choose: (name: string) => put("/api/camera/recognizers", { body: { name } }),
  add: (chosen: File) =>
    post("/api/camera/recognizers", {
      params: { query: { name: chosen.name } },
      headers: { "Content-Type": "application/octet-stream" },
      body: chosen as unknown as string, // the server's description types octets as text
      bodySerializer: (octets) => octets,
    }),
  remove: (name: string) => del("/api/camera/recognizers/{name}", { params: { path: { name } } }),
};

/**
 * The address of the mirrored live picture; a request for it keeps the camera on. Another number
 * makes the browser request it again.
 */
export const previewAddress = (attempt: number) => `/api/camera/preview?attempt=${attempt}`;
