/** What went wrong and what to do about it. */
export interface Message {
  readonly message: string;
  readonly remedy: string;
}

/** A message in the catalogue: its parts have placeholders such as `{{value}}`; a part may have plural forms instead. */
export type MessageEntry = Partial<Message> &
  Readonly<Record<`${keyof Message}_${string}`, string>>;

/** Messages of the server by their codes. */
export type Catalogue = Readonly<Record<string, MessageEntry>>;

/** Blockly's own words by its keys. */
export type BlocklyMessages = Readonly<Record<string, string>>;
