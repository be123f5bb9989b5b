import type { Texts } from "../../i18n";
import { EMERGENCY_KEY } from "../../run/real/real_robot";
import { ACTIONS } from "../run_bar/actions";

export interface KeyRow {
  /** Alternatives; each is a combination of keys pressed together. */
  readonly keys: readonly string[];
  readonly description: string;
}

export interface KeyGroup {
  readonly title: string;
  readonly rows: readonly KeyRow[];
  /** Sentences that name further keys. */
  readonly more?: readonly string[];
}

/** All keys of the studio. If a button has the same action, the description is the text of the button. */
export function keyGroups(texts: Texts): KeyGroup[] {
  const { keys } = texts.help;
  const { studio, scene, solid } = texts;
  return [
    { title: texts.run.bar, rows: [...runRows(texts), emergencyRow(texts)] },
    {
      title: keys.blocks,
      rows: [
        { keys: ["T"], description: keys.palette },
        { keys: ["W"], description: keys.program },
        { keys: ["↑", "↓", "←", "→"], description: keys.arrows },
        { keys: ["Enter"], description: keys.enter },
        { keys: ["M"], description: keys.move },
        { keys: ["Delete"], description: keys.remove },
        { keys: ["Ctrl+C", "Ctrl+V"], description: keys.copy },
        { keys: ["Ctrl+Z"], description: studio.undo },
        { keys: ["Ctrl+Shift+Z"], description: studio.redo },
        { keys: ["Esc"], description: keys.escape },
        { keys: ["Tab"], description: keys.tab },
      ],
    },
    { title: studio.floor, rows: [], more: [scene.startKeys, scene.measureKeys] },
    { title: solid.solidTip, rows: [], more: [solid.keys] },
  ];
}

const emergencyRow = ({ robot }: Texts): KeyRow => ({
  keys: [EMERGENCY_KEY],
  description: robot.emergencyHelp,
});

/** Rows of the run actions. Actions that share a key share a row: one of them is possible at a time. */
function runRows(texts: Texts): KeyRow[] {
  const state = { phase: "idle", unable: false, inFunction: false, stepwise: true } as const;
  const rows = new Map<string, string[]>();
  for (const { shortcut, label, help } of ACTIONS) {
    const text = help?.(texts) ?? label(texts, state);
    rows.set(shortcut, [...(rows.get(shortcut) ?? []), text]);
  }
  return [...rows].map(([key, descriptions]) => ({
    keys: [key],
    description: descriptions.join(", "),
  }));
}
