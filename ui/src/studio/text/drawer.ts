export const TABS = ["python", "ir"] as const;

export type TextTab = (typeof TABS)[number];

/**
 * How the drawer stands: the program as text or the plots, which form of the text, whether it takes the floor's room,
 * whether Python is being written.
 */
export interface DrawerState {
  readonly open: boolean;
  readonly what: "text" | "plots";
  readonly tab: TextTab;
  readonly tall: boolean;
  readonly editing: boolean;
}

export const DRAWER: DrawerState = {
  open: false,
  what: "text",
  tab: "python",
  tall: false,
  editing: false,
};
