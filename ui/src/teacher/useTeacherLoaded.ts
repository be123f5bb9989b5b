import { UNCHANGED } from "../kit/requests/load_state";
import { type Loadable, useLoaded } from "../kit/requests/useLoaded";
import { asTeacher, isSignedOut } from "../shell/teacher/teacher_session";

/**
 * `useLoaded` for what only a teacher may see. It loads again when the window gets the focus back; a session that has
 * ended is then no reason to ask for the PIN, because what is shown stays.
 */
export function useTeacherLoaded<T>(key: unknown, ask: () => Promise<T>): Loadable<T> {
  return useLoaded(key, () => asTeacher(ask), { whenBack: () => ask().catch(unlessSignedOut) });
}

function unlessSignedOut(error: unknown): typeof UNCHANGED {
  if (!isSignedOut(error)) throw error;
  return UNCHANGED;
}
