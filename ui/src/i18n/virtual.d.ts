/** Made by ui/languages.ts from the folders of pinel_desktop/messages/catalogue. */
declare module "virtual:languages" {
  /** A language: what it calls itself, and the parts of its catalogue, each fetched when it is needed. */
  export interface LanguageRow {
    readonly name: string;
    readonly start: () => Promise<import("./compile").Part>;
    readonly lazy: () => Promise<import("./compile").Part>;
  }
  export const rows: Readonly<Record<string, LanguageRow>>;
}
