/* A library, but no engine. */

int an_answer(void);
int an_answer(void) {
    return 42;
}
