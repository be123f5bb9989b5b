import type { ComponentType } from "preact";
import { lazyScreen } from "../shell/lazy";
import type { ScreenName } from "../shell/route";
import { StartScreen } from "../start/StartScreen";
import { StudioScreen } from "../studio/StudioScreen";

type Screen = ComponentType<never>;
/** A file of a screen exports its component under the file's own name. */
type File = Readonly<Record<string, Screen>>;

/** Screens of the first bundle; all others are loaded on demand. */
const FIRST: Partial<Record<ScreenName, Screen>> = { start: StartScreen, studio: StudioScreen };

const FILES = import.meta.glob<File>([
  "../**/*Screen.tsx",
  "!../start/StartScreen.tsx",
  "!../studio/StudioScreen.tsx",
]);

const LAZY = Object.entries(FILES).map(([path, load]) => {
  const component = path.replace(/^.*\/|\.tsx$/g, "");
  const name = component.replace(/Screen$/, "").toLowerCase();
  return [name, async () => (await load())[component] as Screen] as const;
});

/** Functions that import the screens; screens of the first bundle have none. */
export const LOADS: Partial<Record<string, () => Promise<Screen>>> = Object.fromEntries(LAZY);

/**
 * The component of each screen: screen `runs` is `RunsScreen` in `RunsScreen.tsx`, in any folder.
 */
export const PARTS: Partial<Record<string, Screen>> = {
  ...FIRST,
  ...Object.fromEntries(LAZY.map(([name, load]) => [name, lazyScreen(load)])),
};
