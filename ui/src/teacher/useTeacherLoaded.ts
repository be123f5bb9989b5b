import { UNCHANGED } from "../kit/requests/load_state";
import { type Loadable, useLoaded } from "../kit/requests/useLoaded";
import { asTeacher, isSignedOut } from "../shell/teacher/teacher_session";

/**
 * `useLoaded` for data of the teacher's part. Reloads when the window regains focus. If the session
 * has ended by then, it does not ask for the PIN, because the shown data stays.
 */
export function useTeacherLoaded<T>(key: unknown, ask: () => Promise<T>): Loadable<T> {
  return useLoaded(key, () => asTeacher(ask), { onFocus: () => ask().catch(unlessSignedOut) });
}

function unlessSignedOut(error: unknown): typeof UNCHANGED {
  if (!isSignedOut(error)) throw error;
  return UNCHANGED;
}
